// Computes the light of a scene's far surfaces.
#pragma once

#include <memory>

#include "core/progress.h"
#include "render/light/far_light.h"

namespace carom::render {

/// Incremented whenever the light changes for the same scene.
inline constexpr int kFarLightRevision = 3;

/// The light in the scene without what follows tracks; its far region must be given. Cells are
/// found by rays from random places that can be reached from above the region's box, and the
/// irradiance of each is the mean over paths from a few points on its surface, with numbers that
/// depend on the cell. The bits depend on the scene only. Throws Stopped, and Error as
/// PreparedScene does.
[[nodiscard]] std::shared_ptr<const FarLight> bake_far_light(const SceneDescription& scene,
                                                             const WorkContext& context);

}  // namespace carom::render
