// A ball on a level surface: the closed forms of sliding, rolling, spinning and resting
// (Marlow, The Physics of Pocket Billiards, 1995, chapter 2; Alciatore, TP A-4 and TP B-2).
#pragma once

#include "sim/motion/motion_segment.h"

namespace carom::sim {

/// Friction coefficients of the surface that supports the ball.
struct SupportLaw {
    double sliding_friction = 0.2;      // mu_s
    double rolling_friction = 0.01;     // mu_r
    double spinning_friction = 0.0127;  // mu_sp
};

/// Velocity of the ball's lowest point: u = v + w x (-R z).
[[nodiscard]] Vec3 slip_velocity(const MotionState& state, double radius);

/// The segment that begins at `time` from `state`: its law of motion, its accelerations and its
/// end. `gravity` > 0, m/s^2. The vertical velocity is taken as zero. States that differ from
/// rolling or resting only by rounding are corrected.
[[nodiscard]] MotionSegment cloth_segment(double time, const MotionState& state, double radius,
                                          double gravity, const SupportLaw& law);

/// The segment of a ball in flight.
[[nodiscard]] MotionSegment flight_segment(double time, const MotionState& state,
                                           const Vec3& gravity);

}  // namespace carom::sim
