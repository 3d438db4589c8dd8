// Tests for finite values: of input, and in debug builds (CAROM_VALIDATE) of computed values, so
// that a NaN is found where it arises.
#pragma once

#include <cmath>

#include "core/pose.h"

namespace carom {

[[nodiscard]] inline bool is_finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

[[nodiscard]] inline bool is_finite(const Quat& q) {
    return std::isfinite(q.r) && is_finite(q.v);
}

[[nodiscard]] inline bool is_finite(const MotionState& state) {
    return is_finite(state.position) && is_finite(state.orientation) && is_finite(state.velocity) &&
           is_finite(state.angular_velocity);
}

}  // namespace carom
