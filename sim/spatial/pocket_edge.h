// The edge of a circular hole in the cloth.
#pragma once

#include <optional>

#include "sim/motion/contact.h"
#include "sim/motion/motion_segment.h"

namespace carom::sim {

struct PocketEdge {
    Vec3 centre{0, 0, 0};
    double radius = 0;  // of the horizontal circle, m

    [[nodiscard]] Contact contact(const Vec3& ball_centre, double ball_radius) const;
    [[nodiscard]] std::optional<double> impact_time(const MotionSegment& ball, double ball_radius,
                                                    double now, double until) const;
};

}  // namespace carom::sim
