// Radial distortion of a lens.
#pragma once

#include <algorithm>
#include <cmath>

#include <Imath/ImathVec.h>

namespace carom::render {

/// Fitzgibbon 2001, "Simultaneous linear estimation of multiple view geometry and lens distortion",
/// section 2: what a lens without distortion shows at the distance r_u from the centre of the
/// picture is at r_d, where r_u = r_d / (1 + k r_d^2). Its inverse has a closed form. A barrel has
/// k < 0. Places and k have the same unit of length.
///
/// Returns r_d for r_u. Above 1 / (2 sqrt(k)) there is none; such a place is outside of every
/// picture and is only kept there.
template <class T>
[[nodiscard]] Imath::Vec2<T> distorted(const Imath::Vec2<T>& place, T k) {
    const T inside = std::max(T{0}, 1 - 4 * k * place.length2());
    return place * (2 / (1 + std::sqrt(inside)));
}

/// Returns r_u for r_d.
template <class T>
[[nodiscard]] Imath::Vec2<T> undistorted(const Imath::Vec2<T>& place, T k) {
    return place * (1 / (1 + k * place.length2()));
}

/// The area that an element of area at r_d has at r_u: (1 - k r_d^2) / (1 + k r_d^2)^3.
template <class T>
[[nodiscard]] T undistorted_area(const Imath::Vec2<T>& place, T k) {
    const T bend = k * place.length2();
    const T scale = 1 + bend;
    return (1 - bend) / (scale * scale * scale);
}

/// k of a lens whose distortion in a corner of a picture of that size is `in_corner`
/// (LensShape::distortion), with lengths in pixels.
[[nodiscard]] inline double distortion_per_pixel2(double in_corner, int width, int height) {
    const double corner2 =
        0.25 * (static_cast<double>(width) * width + static_cast<double>(height) * height);
    return in_corner / corner2;
}

}  // namespace carom::render
