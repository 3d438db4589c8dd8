// The key of a frame: the hash of its own inputs and of nothing else.
#pragma once

#include "core/hash.h"
#include "pipeline/store/frame_inputs.h"
#include "render/scene/render_settings.h"
#include "render/scene/scene_description.h"

namespace carom::pipeline {

/// Hash of the static part of a scene: its description and the contents of the files that it names
/// (not their paths). Computed once per shot.
[[nodiscard]] Hash128 hash_scene(const render::SceneDescription& scene);

/// Hash of the motion of the tracks while the shutter is open, the camera values, `scene_hash`, the
/// render settings and the renderer's revision. Neither the bake nor names nor the frame's number
/// enter. The frame's seed follows from these (frame_seed.h).
[[nodiscard]] Hash128 frame_key(const FrameInputs& inputs, const render::SceneDescription& scene,
                                const Hash128& scene_hash, const render::RenderSettings& settings);

/// The key of the picture that is made of the frame with the key `noisy` by denoising: the hash of
/// that key, the denoiser's revision and its strength.
[[nodiscard]] Hash128 denoised_key(const Hash128& noisy, double strength);

}  // namespace carom::pipeline
