// Computes the camera values of each frame from the rigs and the timeline.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/camera/camera_rig.h"
#include "pipeline/camera/lens_look.h"
#include "render/camera/camera_state.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// The values of a frame that depend on rigs and time. `scene_open` <= `scene_close` always holds:
/// in reversed time the two ends are exchanged together with their cameras, and `reversed` is true.
/// In frozen time both are equal, and the cameras are in the order of video time.
struct PlannedFrame {
    std::int64_t number = 0;  // frame n is at video time n / fps
    std::string rig;
    double video_time = 0;
    double scene_time = 0;
    double scene_open = 0;
    double scene_close = 0;
    bool reversed = false;
    double speed = 1;   // scene seconds per second of film at this frame; negative in reverse
    double weight = 1;  // in the picture: below 1 during a cross-fade with another rig
    render::CameraState camera_open;   // at scene_open
    render::CameraState camera_close;  // at scene_close
    LensLook look{};                   // does not belong to the picture that is rendered
};

/// The number of frames of the film: those n with n / fps in [start, end) of some rig.
[[nodiscard]] std::int64_t frame_count(std::span<const CameraRig> rigs, const FilmTiming& timing);

/// Plans frame `number`, in [0, frame_count). Throws Error, with the rig's name, if an object that
/// the rig refers to is not in the timeline or the camera's values give no valid view (position
/// equals target ...). During a cross-fade it plans the rig with the larger weight.
[[nodiscard]] PlannedFrame plan_frame(std::int64_t number, std::span<const CameraRig> rigs,
                                      const FilmTiming& timing, const sim::Timeline& timeline);

/// Plans frame `number` of that rig, whether or not it films it. Throws Error without the rig's
/// name.
[[nodiscard]] PlannedFrame plan_frame_of(std::int64_t number, const CameraRig& rig,
                                         const FilmTiming& timing, const sim::Timeline& timeline);

/// Plans everything that frame `number` shows: one frame, or two during a cross-fade. Their weights
/// add up to 1, and the larger one is first. Throws like plan_frame.
[[nodiscard]] std::vector<PlannedFrame> plan_mixed_frame(std::int64_t number,
                                                         std::span<const CameraRig> rigs,
                                                         const FilmTiming& timing,
                                                         const sim::Timeline& timeline);

/// A problem of the timing or of a rig, as a sentence that names the rigs concerned.
struct RigProblem {
    std::string message;
    std::optional<std::size_t> rig;    // index of the rig to change, the later of two
    std::optional<std::size_t> other;  // index of the rig before it
};

/// Finds the problems of the timing and of the rigs as a sequence that starts at video time 0: no
/// rigs, gaps, overlaps, empty intervals, and fades that do not fit.
[[nodiscard]] std::vector<RigProblem> find_problems(std::span<const CameraRig> rigs,
                                                    const FilmTiming& timing);

}  // namespace carom::pipeline
