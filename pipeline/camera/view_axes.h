// The axes of a camera's picture in the world.
#pragma once

#include "render/camera/camera_state.h"

namespace carom::pipeline {

/// Orthonormal: to the right and up in the picture, and ahead along the optical axis.
struct ViewAxes {
    Vec3 right;
    Vec3 up;
    Vec3 ahead;
};

/// Of a valid view (rig_state.h).
[[nodiscard]] ViewAxes view_axes(const render::CameraState& camera);

/// Halves of width and height, at distance 1, of the largest picture without distortion of which a
/// camera's picture shows everything. `aspect`: width / height.
[[nodiscard]] Vec2 innermost(const render::CameraState& camera, double aspect);

/// The same of the smallest picture that shows everything that the camera's picture does.
[[nodiscard]] Vec2 outermost(const render::CameraState& camera, double aspect);

/// Whether some of the ball is within the four edges of the picture and in front of the camera; the
/// lens is a pinhole. A ball just outside of a corner counts as inside, and so does one that is
/// not farther outside than the lens's distortion can move it.
[[nodiscard]] bool is_in_picture(const render::CameraState& camera, double aspect,
                                 const Vec3& centre, double radius);

}  // namespace carom::pipeline
