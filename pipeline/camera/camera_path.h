// The position on a camera path at one instant.
#pragma once

#include <string>

#include "pipeline/camera/camera_rig.h"
#include "pipeline/camera/progress.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// One instant of a rig: its progress along its path, and the scene time.
struct RigInstant {
    Progress progress;
    double scene_time = 0;  // s
};

/// Throws Error if the timeline has no track of that name.
[[nodiscard]] const sim::Track& find_track(const sim::Timeline& timeline, const std::string& name);

/// Throws Error, with the object's name, if an object of the path is not in the timeline.
[[nodiscard]] Vec3 path_position(const CameraPath& path, const RigInstant& instant,
                                 const sim::Timeline& timeline);

/// The track's mean position over a window of `window` seconds centred on `scene_time`. The mean is
/// exact for the interpolated path. A window of 0 gives the position at `scene_time`.
[[nodiscard]] Vec3 mean_position(const sim::Track& track, double scene_time, double window);

}  // namespace carom::pipeline
