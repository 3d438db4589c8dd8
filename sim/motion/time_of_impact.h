// When things on closed-form segments touch: roots of the squared distance, to machine precision.
#pragma once

#include <optional>

#include "sim/motion/motion_segment.h"
#include "sim/numeric/polynomial.h"

namespace carom::sim {

/// Closer than this counts as touching (m): a thousand times the round-off of a located impact.
inline constexpr double kContactDistance = 1e-12;

/// The first time in [now, until] at which the gap closes, `now` itself where it is closed and
/// closing. Pairs that touch and separate are not touching again until they have come apart.
/// All functions here answer by these rules; times are scene times.

/// Two balls whose centres touch at `distance` from each other.
[[nodiscard]] std::optional<double> ball_impact_time(const MotionSegment& a, const MotionSegment& b,
                                                     double distance, double now, double until);

/// The centre comes within `distance` of a point.
[[nodiscard]] std::optional<double> point_impact_time(const MotionSegment& ball, const Vec3& point,
                                                      double distance, double now, double until);

/// The centre comes within `distance` of the endless line through `point` along unit `direction`.
[[nodiscard]] std::optional<double> line_impact_time(const MotionSegment& ball, const Vec3& point,
                                                     const Vec3& direction, double distance,
                                                     double now, double until);

/// The centre comes within `distance` of the plane through `point` with unit `normal`, from the
/// normal's side.
[[nodiscard]] std::optional<double> plane_impact_time(const MotionSegment& ball, const Vec3& point,
                                                      const Vec3& normal, double distance,
                                                      double now, double until);

/// The centre gets further than `distance` from the line (a wall around it).
[[nodiscard]] std::optional<double> line_departure(const MotionSegment& ball, const Vec3& point,
                                                   const Vec3& direction, double distance,
                                                   double now, double until);

}  // namespace carom::sim
