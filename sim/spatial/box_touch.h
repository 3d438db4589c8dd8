// Balls against boxes, still or moving.
#pragma once

#include <optional>

#include "sim/motion/stretch.h"
#include "sim/spatial/static_mesh.h"

namespace carom::sim {

/// A box's motion over a short time: straight, turning at a constant rate.
struct BoxMotion {
    Vec3 half_size{0.5, 0.5, 0.5};
    double start = 0;   // scene time, s
    MotionState state;  // at `start`

    [[nodiscard]] Pose pose_at(double time) const;
};

/// Contact of a ball with a box; works for a centre inside, too.
[[nodiscard]] SurfaceContact box_contact(const Vec3& half_size, const Pose& box, const Vec3& centre,
                                         double radius);

/// When the ball touches the box in [now, until], by the rules of time_of_impact.h.
[[nodiscard]] std::optional<double> box_touch(const Stretch& ball, double radius,
                                              const BoxMotion& box, double now, double until);

/// v from body axes to world axes and back.
[[nodiscard]] Vec3 to_world(const Quat& orientation, const Vec3& v);
[[nodiscard]] Vec3 to_body(const Quat& orientation, const Vec3& v);

}  // namespace carom::sim
