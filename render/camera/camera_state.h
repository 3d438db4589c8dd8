// The parameters of a thin-lens camera at one time.
#pragma once

#include <optional>

#include "core/vectors.h"

namespace carom::render {

/// How a lens differs from a thin lens with a round or polygonal pupil. The pupil of a point of the
/// picture is what a second opening leaves of it: a disk that is shifted towards the picture's
/// centre, in proportion to the distance from it, as the rims of a long lens are when seen from the
/// side. So bokeh is lemon-shaped and the picture darker near its corners (cat's eye).
struct LensShape {
    double cat_eye_ratio = 1;  // radius of the second opening / radius of the lens, >= 1
    double cat_eye_shift = 0;  // in the picture's corner, in radii of the lens, [0, ratio)
    double squeeze = 1;        // width of the pupil / its height, (0, 1]
    /// Part by which a corner of the picture is farther from its centre than without distortion:
    /// negative for a barrel, positive for a pincushion, [-0.3, 0.3].
    double distortion = 0;

    bool operator==(const LensShape&) const = default;
};

struct CameraState {
    Vec3 position{0, -2, 1};
    Vec3 target{0, 0, 0};  // the optical axis runs from position to target
    Vec3 up{0, 0, 1};      // not parallel to the axis
    double roll = 0;       // rad; positive turns the picture clockwise, the camera the other way
    double vertical_fov = 0.7;        // rad, (0, pi)
    double focus_distance = 2;        // along the optical axis, m, > 0
    double lens_radius = 0;           // m, >= 0; 0 is a pinhole
    int blades = 0;                   // 0: round, otherwise >= 3
    double blade_rotation = 0;        // rad
    std::optional<LensShape> lens{};  // none: a thin lens

    bool operator==(const CameraState&) const = default;
};

}  // namespace carom::render
