#include "sim/motion/free_rotation.h"

#include <algorithm>
#include <cmath>

#include "core/rigid.h"
#include "sim/timeline/rotation_segment.h"

namespace carom::sim {
namespace {

constexpr double kMaxTurn = 0.05;  // rad

Vec3 to_world(const Quat& q, const Vec3& v) {
    const Vec3 t = q.v.cross(v) * 2;
    return v + t * q.r + q.v.cross(t);
}

Vec3 divided(const Vec3& a, const Vec3& b) {
    return {a.x / b.x, a.y / b.y, a.z / b.z};
}

/// Body angular velocity at the midpoint: m = (p0 + p1) / 2 solves m = p0 + h/2 m x w, w = m / I.
Vec3 midpoint_velocity(const Vec3& momentum, const Vec3& inertia, double h) {
    Vec3 middle = momentum;
    for (int i = 0; i < 50; ++i) {
        const Vec3 next = momentum + middle.cross(divided(middle, inertia)) * (0.5 * h);
        const Vec3 change = next - middle;
        middle = next;
        if (change.dot(change) <= 1e-34 * momentum.dot(momentum)) {
            break;
        }
    }
    return divided(middle, inertia);
}

/// The Cayley map of h w as a quaternion: (1, h w / 2), normalised.
Quat cayley(const Vec3& omega, double h) {
    const Vec3 v = omega * (0.5 * h);
    const double norm = std::sqrt(1 + v.dot(v));
    return {1 / norm, v / norm};
}

}  // namespace

RotationalState rotate_freely(const RotationalState& from, const Vec3& inertia, double duration) {
    const double speed = std::sqrt(from.angular_velocity.dot(from.angular_velocity));
    if (speed == 0) {
        return from;
    }
    if (inertia.x == inertia.y && inertia.y == inertia.z) {
        return {turned(from.orientation, from.angular_velocity, from.angular_velocity, duration),
                from.angular_velocity};
    }
    const auto count =
        static_cast<int>(std::min(1e5, std::max(1.0, std::ceil(speed * duration / kMaxTurn))));
    const double h = duration / count;
    Quat q = from.orientation;
    // The angular momentum in world axes is constant; that in body axes follows from it.
    const Vec3 body_omega = to_body(q, from.angular_velocity);
    const Vec3 momentum = to_world(
        q, Vec3(body_omega.x * inertia.x, body_omega.y * inertia.y, body_omega.z * inertia.z));
    for (int i = 0; i < count; ++i) {
        const Vec3 in_body = to_body(q, momentum);
        q = q * cayley(midpoint_velocity(in_body, inertia, h), h);
    }
    const double norm = std::sqrt(q.r * q.r + q.v.dot(q.v));
    q = {q.r / norm, q.v / norm};
    const Vec3 omega = divided(to_body(q, momentum), inertia);
    return {q, to_world(q, omega)};
}

MotionState drift(const MotionState& from, const Vec3& inertia, double duration) {
    const RotationalState turned =
        rotate_freely({from.orientation, from.angular_velocity}, inertia, duration);
    return {from.position + from.velocity * duration, turned.orientation, from.velocity,
            turned.angular_velocity};
}

}  // namespace carom::sim
