// Computes a rig's camera values at one instant.
#pragma once

#include <string>
#include <vector>

#include "pipeline/camera/camera_path.h"
#include "pipeline/camera/camera_rig.h"
#include "render/camera/camera_state.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// The vertical field of view of a lens that is focused at infinity, rad:
/// 2 atan(sensor height / (2 focal length)).
[[nodiscard]] double fov_of_lens(double focal_length, double sensor_height);

/// Whether fields of view are measured along the width of a picture with this aspect (width /
/// height), else along its height.
[[nodiscard]] bool measures_width(FovAxis axis, double aspect);

/// The eased number of blades, rounded to the nearest whole number.
[[nodiscard]] int blades_at(const CameraRig& rig, Progress progress);

/// Radius of the lens opening, m: focal length / (2 N), focal length = sensor height / (2 tan(fov /
/// 2)).
[[nodiscard]] double lens_radius(const Aperture& aperture, double vertical_fov,
                                 double sensor_height = 0.024);

/// Shortest focus distance, m. A lens whose object of focus is nearer or behind the camera is
/// focused at this distance.
inline constexpr double kNearestFocus = 0.01;

/// The objects of the rig's focus at that instant that are behind its camera: at most two, while
/// the focus changes from one to the other. Throws as camera_state does.
[[nodiscard]] std::vector<std::string> find_focus_behind_camera(const CameraRig& rig,
                                                                const RigInstant& instant,
                                                                const sim::Timeline& timeline);

/// Throws Error, without the rig's name, if the values give no valid view.
[[nodiscard]] render::CameraState camera_state(const CameraRig& rig, const RigInstant& instant,
                                               const sim::Timeline& timeline);

}  // namespace carom::pipeline
