// A direction at right angles to another one.
#pragma once

#include <cmath>

#include "core/vectors.h"

namespace carom {

/// A unit vector at right angles to the unit `axis`; horizontal unless that is nearly vertical.
[[nodiscard]] inline Vec3 perpendicular(const Vec3& axis) {
    const Vec3 other = std::abs(axis.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
    return other.cross(axis).normalized();
}

}  // namespace carom
