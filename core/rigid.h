// Vectors in the axes of a rigid body, and the velocities of its points.
#pragma once

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

}  // namespace carom
