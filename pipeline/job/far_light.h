// The light of a scene's far surfaces: stored, shipped or computed.
#pragma once

#include <memory>

#include "core/hash.h"
#include "core/progress.h"
#include "pipeline/store/frame_store.h"
#include "render/light/far_light.h"

namespace carom::pipeline {

/// The number of what the light depends on: the scene without what moves.
[[nodiscard]] Hash128 far_light_key(const render::SceneDescription& scene);

/// The light of the scene's file or of the store, if it is that of the scene; else null. A scene
/// without a far region has none. `store` may be null.
[[nodiscard]] std::shared_ptr<const render::FarLight> known_far_light(
    const render::SceneDescription& scene, const FrameStore* store);

/// The same, or the light is computed, and put into the store if that may be written to. Processes
/// with one store do not compute it twice at the same time. Throws Error, Stopped.
[[nodiscard]] std::shared_ptr<const render::FarLight> far_light(
    const render::SceneDescription& scene, const FrameStore* store, const WorkContext& context);

/// The same as known_far_light, or a coarse light, which is computed in about a second, for
/// previews and forecasts.
[[nodiscard]] std::shared_ptr<const render::FarLight> quick_far_light(
    const render::SceneDescription& scene, const FrameStore* store, const WorkContext& context);

}  // namespace carom::pipeline
