// Lengths and directions of vectors, in as few operations as there are.
#pragma once

#include <cmath>

#include "core/vectors.h"

namespace carom {

/// Without the care that Imath's length() takes of vectors whose square is no normal number.
[[nodiscard]] inline double length(const Vec3& v) {
    return std::sqrt(v.dot(v));
}

/// The vector of length 1 along `v`, which is not zero.
[[nodiscard]] inline Vec3 unit(const Vec3& v) {
    return v / length(v);
}

[[nodiscard]] inline Imath::V3f unit(const Imath::V3f& v) {
    return v * (1 / std::sqrt(v ^ v));
}

}  // namespace carom
