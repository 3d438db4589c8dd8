// Moves a camera along its axis so that given points are inside its picture.
#pragma once

#include "pipeline/camera/camera_rig.h"
#include "render/camera/camera_state.h"

namespace carom::pipeline {

/// The camera with the same direction, roll and field of view at the nearest place on its axis from
/// which all points are inside the picture, with the free margin at each edge. A point at x to the
/// right of the axis and at depth z beyond the target is inside if |x| <= (z + d) (1 - 2 margin)
/// tan(fov / 2), where d is the distance to the target, so the largest such d over all points and
/// both sides of the picture is the distance.
///
/// The target stays where it is; if the camera would pass it, the target becomes a point just ahead
/// of the camera. `aspect`: width / height of the picture. There is at least one point.
[[nodiscard]] render::CameraState framed(const render::CameraState& camera, const Framing& framing,
                                         double aspect);

}  // namespace carom::pipeline
