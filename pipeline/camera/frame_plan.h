// From rigs and a timeline to each frame's camera values.
#pragma once

#include <cstdint>
#include <optional>
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
    double speed = 1;   // scene seconds per second of film at this frame; negative in reverse
    double weight = 1;  // in the picture: below 1 while another rig fades in or out
    render::CameraState camera_open;   // at scene_open
    render::CameraState camera_close;  // at scene_close
};

/// Frames of the whole film: those n with n / fps in [start, end) of some rig.
[[nodiscard]] std::int64_t frame_count(std::span<const CameraRig> rigs, const FilmTiming& timing);

/// Frame `number`, in [0, frame_count). Throws Error naming the rig if an object it refers to is
/// not in the timeline or the camera's values make no picture (position equals target ...).
/// Of two rigs that fade into each other, the one that is seen more.
[[nodiscard]] PlannedFrame plan_frame(std::int64_t number, std::span<const CameraRig> rigs,
                                      const FilmTiming& timing, const sim::Timeline& timeline);

/// All that is seen in frame `number`: one frame, or two of rigs that fade into each other. Their
/// weights add up to 1, the larger one first. Throws like plan_frame.
[[nodiscard]] std::vector<PlannedFrame> plan_mixed_frame(std::int64_t number,
                                                         std::span<const CameraRig> rigs,
                                                         const FilmTiming& timing,
                                                         const sim::Timeline& timeline);

/// Something wrong with the timing or a rig, as a sentence that names the rigs concerned.
struct RigProblem {
    std::string message;
    std::optional<std::size_t> rig;    // index of the one to change first, the later of two
    std::optional<std::size_t> other;  // the one before it
};

/// All that is wrong with the timing and with the rigs as a sequence from video time 0 on (none,
/// gaps, overlaps, stretches that do not go forward, fades that do not fit).
[[nodiscard]] std::vector<RigProblem> find_problems(std::span<const CameraRig> rigs,
                                                    const FilmTiming& timing);

}  // namespace carom::pipeline
