// What a frame's pixels depend on besides the still scene and the settings, cut out of shot and
// timeline and made canonical.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/camera/camera_rig.h"
#include "pipeline/camera/frame_plan.h"
#include "render/frame/frame.h"
#include "render/scene/scene_description.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// What render_frame is given. A track that rests while the shutter is open, or is seen in frozen
/// time, has its pose as its only key; if all do, the interval is [0, 0]. So frames that show the
/// same have the same inputs, and render to the same bits, whatever their scene time.
struct FrameInputs {
    std::vector<sim::Track> tracks;  // those that the scene names, in order of first mention
    render::FrameInput frame;
};

/// `render_seed`: chooses the frame's noise (frame_seed.h). Throws Error naming a track that the
/// timeline lacks.
[[nodiscard]] FrameInputs frame_inputs(const PlannedFrame& frame, const Shutter& shutter,
                                       const render::SceneDescription& scene,
                                       const sim::Timeline& timeline, std::uint64_t render_seed);

}  // namespace carom::pipeline
