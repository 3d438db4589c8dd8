// Lengths and directions of vectors with the fewest operations.
#pragma once

#include <cmath>

#include "core/vectors.h"

namespace carom {

/// The length. Unlike Imath's length(), it does not treat vectors specially whose square is not a
/// normal number.
[[nodiscard]] inline double length(const Vec3& v) {
    return std::sqrt(v.dot(v));
}

/// The unit vector along `v`, which is not zero.
[[nodiscard]] inline Vec3 unit(const Vec3& v) {
    return v / length(v);
}

[[nodiscard]] inline Imath::V3f unit(const Imath::V3f& v) {
    return v * (1 / std::sqrt(v ^ v));
}

}  // namespace carom
