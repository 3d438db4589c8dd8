// The parameters of a thin-lens camera at one time.
#pragma once

#include "core/vectors.h"

namespace carom::render {

struct CameraState {
    Vec3 position{0, -2, 1};
    Vec3 target{0, 0, 0};  // the optical axis runs from position to target
    Vec3 up{0, 0, 1};      // not parallel to the axis
    double roll = 0;       // rad; positive turns the picture clockwise, the camera the other way
    double vertical_fov = 0.7;  // rad, (0, pi)
    double focus_distance = 2;  // along the optical axis, m, > 0
    double lens_radius = 0;     // m, >= 0; 0 is a pinhole
    int blades = 0;             // 0: round, otherwise >= 3
    double blade_rotation = 0;  // rad

    bool operator==(const CameraState&) const = default;
};

}  // namespace carom::render
