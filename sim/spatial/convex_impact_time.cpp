#include "sim/spatial/convex_impact_time.h"

#include <algorithm>

#include "core/length.h"
#include "sim/spatial/conservative_advancement.h"
#include "sim/timeline/rotation.h"

namespace carom::sim {

Pose ConvexMotion::pose_at(double time) const {
    const double t = time - start;
    return {state.position + state.velocity * t,
            rotation_from_vector(state.angular_velocity * t) * state.orientation};
}

Contact convex_contact(const ConvexShape& shape, const Pose& pose, const Vec3& centre,
                       double radius) {
    const NearestPoint found =
        nearest_point(shape, to_body(pose.orientation, centre - pose.position));
    Contact contact;
    contact.point = pose.position + to_world(pose.orientation, found.point);
    contact.normal = to_world(pose.orientation, found.normal);
    contact.depth = radius - found.distance;
    return contact;
}

std::optional<double> convex_impact_time(const MotionSegment& ball, double radius,
                                         const ConvexMotion& solid, double now, double until) {
    const double span = until - now;
    if (!(span >= 0)) {
        return std::nullopt;
    }
    const double bounding_radius = solid.shape->bounding_radius();
    const double ball_speed =
        std::max(length(ball.velocity_at(now)), length(ball.velocity_at(until)));
    const double solid_speed =
        length(solid.state.velocity) + bounding_radius * length(solid.state.angular_velocity);
    const double speed = ball_speed + solid_speed;
    const Vec3 centre = solid.state.position + solid.state.velocity * (now - solid.start);
    const Vec3 apart = ball.position_at(now) - centre;
    if (length(apart) > bounding_radius + radius + speed * span) {
        return std::nullopt;
    }
    const auto gap_at = [&](double time) {
        return -convex_contact(*solid.shape, solid.pose_at(time), ball.position_at(time), radius)
                    .depth;
    };
    return first_closing(gap_at, speed, now, until);
}

}  // namespace carom::sim
