// The values of a rig's camera at one instant.
#pragma once

#include <string>
#include <vector>

#include "pipeline/camera/camera_path.h"
#include "pipeline/camera/camera_rig.h"
#include "render/camera/camera_state.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// Vertical, rad: 2 atan(sensor height / (2 focal length)), focused at infinity.
[[nodiscard]] double fov_of_lens(double focal_length, double sensor_height);

/// The whole number of blades nearest to what the easing says.
[[nodiscard]] int blades_at(const CameraRig& rig, Progress progress);

/// Radius of the lens opening, m: focal length / (2 N), focal length = sensor height / (2 tan(fov /
/// 2)).
[[nodiscard]] double lens_radius(const Aperture& aperture, double vertical_fov,
                                 double sensor_height = 0.024);

/// A lens that is to be focused on something behind the camera or nearer than this is focused as
/// near as it can, m.
inline constexpr double kNearestFocus = 0.01;

/// The objects that the rig should be focused on at that instant and that are behind its camera:
/// at most two, on the way from one to the other. Throws as camera_state does.
[[nodiscard]] std::vector<std::string> focus_behind_camera(const CameraRig& rig,
                                                           const RigInstant& instant,
                                                           const sim::Timeline& timeline);

/// Throws Error, without the rig's name, if the values make no picture.
[[nodiscard]] render::CameraState camera_state(const CameraRig& rig, const RigInstant& instant,
                                               const sim::Timeline& timeline);

}  // namespace carom::pipeline
