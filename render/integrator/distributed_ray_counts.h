// How many rays the distributed integrator sent, compared with two predictions.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/film/film.h"
#include "render/scene/distributed_settings.h"
#include "render/scene/render_settings.h"

namespace carom::render {

/// The classic estimate for one pixel: blur x lens x (L S + sum over n = 1 ... r of 2 L S (R +
/// T)^n), from the description of the older scene format (its section 6.2).
[[nodiscard]] double rays_by_classic_formula(const DistributedSettings& settings,
                                             std::size_t lights);

/// The same text's estimate for one pixel without distribution (its section 6.1): 2 L (2^r - 1),
/// where the camera's ray is the first of r generations.
[[nodiscard]] double rays_without_distribution(int generations, std::size_t lights);

/// Numbers of rays predicted for the camera rays that were counted, in any number of frames.
struct RayFormulas {
    double full = 0;     // if every surface reflected and refracted
    double classic = 0;  // rays_by_classic_formula
};
[[nodiscard]] RayFormulas ray_formulas(const RenderStatistics& count,
                                       const RenderSettings& settings, std::size_t lights);

/// The counted rays, in any number of frames, next to both predictions: lines of text that explain
/// the differences.
[[nodiscard]] std::vector<std::string> describe_rays(const RenderStatistics& count,
                                                     const RenderSettings& settings,
                                                     std::size_t lights);

}  // namespace carom::render
