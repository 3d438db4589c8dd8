// From rigs and a timeline to each frame's camera values.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pipeline/camera/camera_rig.h"
#include "render/camera/camera_state.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// Everything about a frame that comes from rigs and time. `scene_open` <= `scene_close` always
/// (canonical): in reversed time the ends are exchanged, cameras included, and `reversed` says so.
/// In frozen time both are equal and the cameras stand in the order of video time.
struct PlannedFrame {
    std::int64_t number = 0;  // frame n is at video time n / fps
    std::string rig;
    double video_time = 0;
    double scene_time = 0;
    double scene_open = 0;
    double scene_close = 0;
    bool reversed = false;
    render::CameraState camera_open;   // at scene_open
    render::CameraState camera_close;  // at scene_close
};

/// Frames of the whole film: those n with n / fps in [start, end) of some rig.
[[nodiscard]] std::int64_t frame_count(std::span<const CameraRig> rigs, const FilmTiming& timing);

/// Frame `number`, in [0, frame_count). Throws Error naming the rig if an object it refers to is
/// not in the timeline or the camera's values make no picture (position equals target ...).
[[nodiscard]] PlannedFrame plan_frame(std::int64_t number, std::span<const CameraRig> rigs,
                                      const FilmTiming& timing, const sim::Timeline& timeline);

/// All that is wrong with the timing and with the rigs as a sequence from video time 0 on (none,
/// gaps, overlaps, stretches that do not go forward), one sentence each.
[[nodiscard]] std::vector<std::string> find_problems(std::span<const CameraRig> rigs,
                                                     const FilmTiming& timing);

}  // namespace carom::pipeline
