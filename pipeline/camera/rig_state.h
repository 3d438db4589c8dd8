// The values of a rig's camera at one instant.
#pragma once

#include "pipeline/camera/camera_path.h"
#include "pipeline/camera/camera_rig.h"
#include "render/camera/camera_state.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// Height of the film that f-numbers refer to, m (full frame).
inline constexpr double kSensorHeight = 0.024;

/// Radius of the lens opening, m: focal length / (2 N), focal length = sensor height / (2 tan(fov /
/// 2)).
[[nodiscard]] double lens_radius(const Aperture& aperture, double vertical_fov);

/// Throws Error, without the rig's name, if the values make no picture.
[[nodiscard]] render::CameraState camera_state(const CameraRig& rig, const RigInstant& instant,
                                               const sim::Timeline& timeline);

}  // namespace carom::pipeline
