// Balls against convex solids, still or moving.
#pragma once

#include <optional>

#include "sim/motion/motion_segment.h"
#include "sim/shape/convex_shape.h"
#include "sim/spatial/axes.h"
#include "sim/spatial/static_mesh.h"

namespace carom::sim {

/// A solid's motion over a short time: straight, turning at a constant rate.
struct ConvexMotion {
    const ConvexShape* shape = nullptr;
    double start = 0;   // scene time, s
    MotionState state;  // at `start`

    [[nodiscard]] Pose pose_at(double time) const;
};

/// Contact of a ball with a solid; works for a centre inside, too.
[[nodiscard]] SurfaceContact convex_contact(const ConvexShape& shape, const Pose& pose,
                                            const Vec3& centre, double radius);

/// When the ball touches the solid in [now, until], by the rules of time_of_impact.h.
[[nodiscard]] std::optional<double> convex_impact_time(const MotionSegment& ball, double radius,
                                                       const ConvexMotion& solid, double now,
                                                       double until);

}  // namespace carom::sim
