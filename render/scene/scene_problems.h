// What of a scene and of the settings cannot be rendered, seen from the descriptions alone.
#pragma once

#include <cstddef>
#include <vector>

#include "core/diagnostic.h"
#include "render/scene/render_settings.h"
#include "render/scene/scene_description.h"

namespace carom::render {

/// The longest side that a picture may have, in pixels.
inline constexpr int kLongestSide = 16384;

/// What the tree of rays of one camera ray grows by.
struct RayBranches {
    std::size_t lights = 0;  // those that shadow rays are sent to
    bool reflects = false;   // whether some surface sends on reflected rays
    bool refracts = false;   // and refracted ones
};
[[nodiscard]] RayBranches ray_branches(const SceneDescription& scene);

/// Lights without an area, a direction or a finite radiance, rectangles without right angles,
/// angles out of order, a second environment.
[[nodiscard]] std::vector<Diagnostic> find_problems(const std::vector<LightDescription>& lights);

/// Counts of the distributed integrator that ask for more rays than can be had.
[[nodiscard]] std::vector<Diagnostic> find_problems(const DistributedSettings& settings,
                                                    const RayBranches& branches);

}  // namespace carom::render
