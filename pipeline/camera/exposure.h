// The exact times of one frame's exposure, in both clocks.
#pragma once

#include <cstdint>
#include <span>

#include "pipeline/camera/camera_rig.h"
#include "pipeline/camera/progress.h"
#include "pipeline/camera/time_map.h"
#include "pipeline/camera/wide_rational.h"

namespace carom::pipeline {

/// The times are in the order of video time: the shutter opens, then closes. Scene times descend
/// when time is reversed.
///
/// With the shutter on the video clock, the exposed interval of scene time is the map of the
/// exposed interval of video time. On the scene clock it has `exposure` seconds in the map's
/// direction, at any speed, and none when time is frozen. The camera always moves for `exposure`
/// seconds of video time.
struct Exposure {
    WideRational video_time;
    WideRational video_open;
    WideRational video_close;
    WideRational scene_time;
    WideRational scene_open;
    WideRational scene_close;
};

/// Frame `number` is at number / fps, exactly.
[[nodiscard]] WideRational frame_time(std::int64_t number, const FilmTiming& timing);

[[nodiscard]] Exposure expose(const CameraRig& rig, std::int64_t number, const FilmTiming& timing);

/// The rig's progress along its path at `video_time`.
[[nodiscard]] Progress progress_at(const CameraRig& rig, const WideRational& video_time);

}  // namespace carom::pipeline
