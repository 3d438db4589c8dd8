// A frame's identity: the hash of its own inputs and nothing else.
#pragma once

#include "core/hash.h"
#include "pipeline/store/frame_inputs.h"
#include "render/scene/render_settings.h"
#include "render/scene/scene_description.h"

namespace carom::pipeline {

/// Hash of the still part of a scene: description and the contents of the files it names (not
/// their paths). Computed once per shot.
[[nodiscard]] Hash128 hash_scene(const render::SceneDescription& scene);

/// Hash of: what the tracks do while the shutter is open, camera values, `scene_hash`, render
/// settings, the renderer's revision and SIMD tier. Neither the bake nor names nor the frame's
/// number enter. The frame's seed follows from these (frame_seed.h), so it does not enter by
/// itself.
[[nodiscard]] Hash128 frame_key(const FrameInputs& inputs, const render::SceneDescription& scene,
                                const Hash128& scene_hash, const render::RenderSettings& settings);

}  // namespace carom::pipeline
