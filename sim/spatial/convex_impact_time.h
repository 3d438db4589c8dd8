// Contacts and impact times of balls with convex solids, at rest or moving.
#pragma once

#include <optional>

#include "core/rigid.h"
#include "sim/motion/contact.h"
#include "sim/motion/motion_segment.h"
#include "sim/shape/convex_shape.h"

namespace carom::sim {

/// Motion of a solid during a short time, with constant velocity and angular velocity.
struct ConvexMotion {
    const ConvexShape* shape = nullptr;
    double start = 0;   // scene time, s
    MotionState state;  // at `start`

    [[nodiscard]] Pose pose_at(double time) const;
};

/// Contact of a ball with a solid; the ball's centre may be inside the solid.
[[nodiscard]] Contact convex_contact(const ConvexShape& shape, const Pose& pose, const Vec3& centre,
                                     double radius);

/// The time in [now, until] at which the ball hits the solid, by the rules of time_of_impact.h.
[[nodiscard]] std::optional<double> convex_impact_time(const MotionSegment& ball, double radius,
                                                       const ConvexMotion& solid, double now,
                                                       double until);

}  // namespace carom::sim
