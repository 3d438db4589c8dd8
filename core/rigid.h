// Vectors in the axes of a rigid body, and the velocities of its points.
#pragma once

#include <cmath>

#include "core/length.h"
#include "core/pose.h"

namespace carom {

[[nodiscard]] inline Vec3 to_world(const Quat& orientation, const Vec3& v) {
    const Vec3 t = orientation.v.cross(v) * 2;
    return v + t * orientation.r + orientation.v.cross(t);
}

[[nodiscard]] inline Vec3 to_body(const Quat& orientation, const Vec3& v) {
    return to_world(Quat(orientation.r, -orientation.v), v);
}

/// The velocity (m/s) of the body's point that is at `point`.
[[nodiscard]] inline Vec3 velocity_at(const MotionState& body, const Vec3& point) {
    return body.velocity + body.angular_velocity.cross(point - body.position);
}

/// The part of `v` across a unit vector.
[[nodiscard]] inline Vec3 across(const Vec3& v, const Vec3& normal) {
    return v - normal * v.dot(normal);
}

/// The direction of `v` across a unit vector, or any if that part is not longer than `least`.
[[nodiscard]] inline Vec3 direction_across(const Vec3& v, const Vec3& normal, double least) {
    const Vec3 part = across(v, normal);
    const double size = length(part);
    if (size > least) {
        return part / size;
    }
    const Vec3 axis = std::abs(normal.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    return unit(normal.cross(axis));
}

}  // namespace carom
