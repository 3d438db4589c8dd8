#include "sim/spatial/pocket_edge.h"

#include <algorithm>

#include "core/length.h"
#include "sim/spatial/conservative_advancement.h"

namespace carom::sim {

Contact PocketEdge::contact(const Vec3& ball_centre, double ball_radius) const {
    Vec3 outwards(ball_centre.x - centre.x, ball_centre.y - centre.y, 0);
    const double from_axis = length(outwards);
    outwards = from_axis > 1e-12 ? outwards / from_axis : Vec3(1, 0, 0);
    Contact contact;
    contact.point = centre + outwards * radius;
    const Vec3 d = ball_centre - contact.point;
    const double distance = length(d);
    contact.normal = distance > 1e-12 ? d / distance : Vec3(0, 0, 1);
    contact.depth = ball_radius - distance;
    return contact;
}

std::optional<double> PocketEdge::impact_time(const MotionSegment& ball, double ball_radius,
                                              double now, double until) const {
    const double speed = std::max(length(ball.velocity_at(now)), length(ball.velocity_at(until)));
    const Vec3 apart = ball.position_at(now) - centre;
    if (length(apart) > radius + ball_radius + speed * (until - now)) {
        return std::nullopt;
    }
    const auto gap_at = [&](double time) {
        return -contact(ball.position_at(time), ball_radius).depth;
    };
    return first_closing(gap_at, speed, now, until);
}

}  // namespace carom::sim
