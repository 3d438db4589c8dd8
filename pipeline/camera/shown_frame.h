// Finds the frame of a film that shows a scene time.
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

}  // namespace carom::pipeline
