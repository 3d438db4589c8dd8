// Checks of scene descriptions and settings: what cannot be rendered.
#pragma once

#include <cstddef>
#include <vector>

#include "core/diagnostic.h"
#include "render/scene/render_settings.h"
#include "render/scene/scene_description.h"

namespace carom::render {

/// The longest side that a picture may have, in pixels.
inline constexpr int kLongestSide = 16384;

/// Whether it may emit light.
[[nodiscard]] bool is_emissive(const MaterialDescription& material);

/// What determines the size of the ray tree of one camera ray.
struct RayBranches {
    std::size_t lights = 0;  // number of lights that shadow rays are sent to
    bool reflects = false;   // some surface reflects
    bool refracts = false;   // some surface refracts
};
[[nodiscard]] RayBranches ray_branches(const SceneDescription& scene);

/// Finds lights without an area, a direction or a finite radiance, rectangles without right angles,
/// spot angles out of order, and a second environment.
[[nodiscard]] std::vector<Diagnostic> find_problems(const std::vector<LightDescription>& lights);

/// Finds counts of the distributed integrator that require too many rays.
[[nodiscard]] std::vector<Diagnostic> find_problems(const DistributedSettings& settings,
                                                    const RayBranches& branches);

}  // namespace carom::render
