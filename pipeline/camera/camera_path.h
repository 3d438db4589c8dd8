// Where a camera path is at one instant.
#pragma once

#include <string>

#include "pipeline/camera/camera_rig.h"
#include "pipeline/camera/progress.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// One instant of a rig: how far along it is, and what the scene's clock shows.
struct RigInstant {
    Progress progress;
    double scene_time = 0;  // s
};

/// The track of that name; throws Error if there is none.
[[nodiscard]] const sim::Track& find_track(const sim::Timeline& timeline, const std::string& name);

/// Throws Error naming an object that is not in the timeline.
[[nodiscard]] Vec3 path_position(const CameraPath& path, const RigInstant& instant,
                                 const sim::Timeline& timeline);

/// The track's mean position over `window` seconds centred on `scene_time`, exact for the
/// interpolated path; at `scene_time` itself if `window` is 0.
[[nodiscard]] Vec3 mean_position(const sim::Track& track, double scene_time, double window);

}  // namespace carom::pipeline
