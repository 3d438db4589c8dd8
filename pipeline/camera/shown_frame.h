// Finds where a film shows a scene time.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "pipeline/camera/camera_rig.h"

namespace carom::pipeline {

/// The first frame whose scene time is nearest to `scene_time` (s) where the film passes it, in
/// either direction. Empty if the film does not show that time.
[[nodiscard]] std::optional<std::int64_t> first_frame_showing(double scene_time,
                                                              std::span<const CameraRig> rigs,
                                                              const FilmTiming& timing);

/// The first video time (s) from which on the film has shown the scene at `scene_time` (s) or
/// later, whatever it shows afterwards: replays do not undo it, and where the film leaves out that
/// time it is that of the cut. During a cross-fade the camera counts that is the stronger one.
/// Empty if the film ends before.
[[nodiscard]] std::optional<double> time_reached(double scene_time,
                                                 std::span<const CameraRig> rigs);

}  // namespace carom::pipeline
