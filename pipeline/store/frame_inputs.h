// The inputs of a frame in canonical form: everything that its pixels depend on besides the static
// part of the scene and the settings.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/camera/camera_rig.h"
#include "pipeline/camera/frame_plan.h"
#include "render/frame/frame.h"
#include "render/scene/scene_description.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// The arguments of render_frame. A track that rests while the shutter is open, or that is shown in
/// frozen time, has its pose as its only key. If all tracks do, the interval is [0, 0]. So frames
/// that show the same have the same inputs and render to the same bits, whatever their scene time.
struct FrameInputs {
    std::vector<sim::Track> tracks;  // that the scene names, in order of first mention
    render::FrameInput frame;
};

/// `render_seed` selects the frame's noise (frame_seed.h). Throws an Error that names a track if
/// the timeline does not have it.
[[nodiscard]] FrameInputs frame_inputs(const PlannedFrame& frame, const Shutter& shutter,
                                       const render::SceneDescription& scene,
                                       const sim::Timeline& timeline, std::uint64_t render_seed);

}  // namespace carom::pipeline
