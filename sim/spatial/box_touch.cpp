#include "sim/spatial/box_touch.h"

#include <algorithm>
#include <cmath>

#include "sim/numeric/rotation.h"
#include "sim/spatial/advance.h"

namespace carom::sim {
namespace {

double length(const Vec3& v) {
    return std::sqrt(v.dot(v));
}

/// For a centre inside the box: out through the nearest face.
SurfaceContact contact_from_inside(const Vec3& half_size, const Pose& box, const Vec3& local,
                                   double radius) {
    int nearest = 0;
    for (int axis = 1; axis < 3; ++axis) {
        if (half_size[axis] - std::abs(local[axis]) < half_size[nearest] - std::abs(local[nearest]))
            nearest = axis;
    }
    Vec3 normal(0, 0, 0);
    normal[nearest] = local[nearest] >= 0 ? 1 : -1;
    Vec3 point = local;
    point[nearest] = normal[nearest] * half_size[nearest];
    SurfaceContact contact;
    contact.point = box.position + to_world(box.orientation, point);
    contact.normal = to_world(box.orientation, normal);
    contact.depth = radius + half_size[nearest] - std::abs(local[nearest]);
    return contact;
}

}  // namespace

Vec3 to_world(const Quat& q, const Vec3& v) {
    const Vec3 t = q.v.cross(v) * 2;
    return v + t * q.r + q.v.cross(t);
}

Vec3 to_body(const Quat& q, const Vec3& v) {
    return to_world(Quat(q.r, -q.v), v);
}

Pose BoxMotion::pose_at(double time) const {
    const double t = time - start;
    return {state.position + state.velocity * t,
            rotation_by(state.angular_velocity * t) * state.orientation};
}

SurfaceContact box_contact(const Vec3& half_size, const Pose& box, const Vec3& centre,
                           double radius) {
    const Vec3 local = to_body(box.orientation, centre - box.position);
    Vec3 nearest = local;
    for (int axis = 0; axis < 3; ++axis)
        nearest[axis] = std::clamp(local[axis], -half_size[axis], half_size[axis]);
    const Vec3 d = local - nearest;
    const double distance = length(d);
    if (distance < 1e-12)
        return contact_from_inside(half_size, box, local, radius);
    SurfaceContact contact;
    contact.point = box.position + to_world(box.orientation, nearest);
    contact.normal = to_world(box.orientation, d / distance);
    contact.depth = radius - distance;
    return contact;
}

std::optional<double> box_touch(const Stretch& ball, double radius, const BoxMotion& box,
                                double now, double until) {
    const double span = until - now;
    if (!(span >= 0))
        return std::nullopt;
    const double reach = length(box.half_size);
    const double ball_speed =
        std::max(length(ball.velocity_at(now)), length(ball.velocity_at(until)));
    const double box_speed =
        length(box.state.velocity) + reach * length(box.state.angular_velocity);
    const double speed = ball_speed + box_speed;
    const Vec3 apart = ball.position_at(now) - box.pose_at(now).position;
    if (length(apart) > reach + radius + speed * span)
        return std::nullopt;
    const auto gap_at = [&](double time) {
        return -box_contact(box.half_size, box.pose_at(time), ball.position_at(time), radius).depth;
    };
    return first_closing(gap_at, speed, now, until);
}

}  // namespace carom::sim
