// Times of impact on closed-form segments: roots of the squared distance, to machine precision.
#pragma once

#include <optional>

#include "sim/motion/motion_segment.h"
#include "sim/numeric/polynomial.h"

namespace carom::sim {

// All functions return the first time in [now, until] at which a gap closes, or `now` if the gap is
// closed and still closing. A pair that touches and separates has to come apart before it can touch
// again. Times are scene times.

/// The centres of two balls come within `distance` of each other.
[[nodiscard]] std::optional<double> ball_impact_time(const MotionSegment& a, const MotionSegment& b,
                                                     double distance, double now, double until);

/// The centre comes within `distance` of a point.
[[nodiscard]] std::optional<double> point_impact_time(const MotionSegment& ball, const Vec3& point,
                                                      double distance, double now, double until);

/// The centre comes within `distance` of the infinite line through `point` along unit `direction`.
[[nodiscard]] std::optional<double> line_impact_time(const MotionSegment& ball, const Vec3& point,
                                                     const Vec3& direction, double distance,
                                                     double now, double until);

/// The centre comes within `distance` of the plane through `point` with unit `normal`, from the
/// normal's side.
[[nodiscard]] std::optional<double> plane_impact_time(const MotionSegment& ball, const Vec3& point,
                                                      const Vec3& normal, double distance,
                                                      double now, double until);

/// The centre gets farther than `distance` from the line (a wall around it).
[[nodiscard]] std::optional<double> line_departure(const MotionSegment& ball, const Vec3& point,
                                                   const Vec3& direction, double distance,
                                                   double now, double until);

}  // namespace carom::sim
