// Conversion of vectors between body axes and world axes.
#pragma once

#include "core/vectors.h"

namespace carom::sim {

[[nodiscard]] inline Vec3 to_world(const Quat& orientation, const Vec3& v) {
    const Vec3 t = orientation.v.cross(v) * 2;
    return v + t * orientation.r + orientation.v.cross(t);
}

[[nodiscard]] inline Vec3 to_body(const Quat& orientation, const Vec3& v) {
    return to_world(Quat(orientation.r, -orientation.v), v);
}

}  // namespace carom::sim
