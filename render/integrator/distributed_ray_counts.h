// How many rays the distributed integrator sent, and how many were foretold.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/film/film.h"
#include "render/scene/distributed_settings.h"
#include "render/scene/render_settings.h"

namespace carom::render {

/// The classic estimate for one pixel: blur x lens x (L S + sum over n = 1 ... r of
/// 2 L S (R + T)^n), by the text that the older scene format comes from (its section 6.2).
[[nodiscard]] double rays_by_classic_formula(const DistributedSettings& settings,
                                             std::size_t lights);

/// Rays foretold for as many camera rays as were counted, in any number of frames.
struct RayFormulas {
    double full = 0;     // if every surface reflected and refracted
    double classic = 0;  // by the classic formula
};
[[nodiscard]] RayFormulas ray_formulas(const RenderStatistics& count,
                                       const RenderSettings& settings, std::size_t lights);

/// What was counted, in any number of frames, beside both formulas: lines of text that say why they
/// differ.
[[nodiscard]] std::vector<std::string> describe_rays(const RenderStatistics& count,
                                                     const RenderSettings& settings,
                                                     std::size_t lights);

}  // namespace carom::render
