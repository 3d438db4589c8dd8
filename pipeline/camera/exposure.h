// The exact times of one frame's exposure, in both clocks.
#pragma once

#include <cstdint>
#include <span>

#include "pipeline/camera/camera_rig.h"
#include "pipeline/camera/progress.h"
#include "pipeline/camera/time_map.h"
#include "pipeline/camera/wide_rational.h"

namespace carom::pipeline {

/// In the order of video time: the shutter opens, then closes. Scene times descend in reverse.
///
/// With the shutter on the video clock the scene shows what the map makes of the stretch of video
/// time. On the scene clock it shows `exposure` seconds of its own time in the map's direction,
/// whatever the speed, and none when frozen. The camera lives on video time: it always moves for
/// `exposure` seconds of that.
struct Exposure {
    WideRational video_time;
    WideRational video_open;
    WideRational video_close;
    WideRational scene_time;
    WideRational scene_open;
    WideRational scene_close;
};

/// Exact: frame `number` is at number / fps.
[[nodiscard]] WideRational frame_time(std::int64_t number, const FilmTiming& timing);

[[nodiscard]] Exposure expose(const CameraRig& rig, std::int64_t number, const FilmTiming& timing);

/// How much of its way the rig has behind it at `video_time`.
[[nodiscard]] Progress progress_at(const CameraRig& rig, const WideRational& video_time);

}  // namespace carom::pipeline
