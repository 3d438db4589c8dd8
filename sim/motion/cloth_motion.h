// A ball on a level surface: the closed forms of sliding, rolling, spinning and resting
// (Marlow, The Physics of Pocket Billiards, 1995, chapter 2; Alciatore, TP A-4 and TP B-2).
#pragma once

#include "sim/motion/motion_segment.h"

namespace carom::sim {

/// Friction coefficients of the surface that supports the ball.
struct FrictionCoefficients {
    double sliding_friction = 0.2;      // mu_s
    double rolling_friction = 0.01;     // mu_r
    double spinning_friction = 0.0127;  // mu_sp
};

/// Velocity of the ball's lowest point: u = v + w x (-R z).
[[nodiscard]] Vec3 slip_velocity(const MotionState& state, double radius);

/// The segment that begins at `time` from `state`: its law of motion, its accelerations and its
/// end. `gravity` > 0, m/s^2, across the surface, and `pull`, the part along it: horizontal, not
/// zero if the surface is off level. The vertical velocity is taken as zero. States that differ
/// from rolling or resting only by rounding are corrected.
///
/// Where the pull is not along the motion, the direction of friction turns. Then a segment lasts
/// only as long as it may be taken as constant, and another of the same kind follows: the error of
/// the position grows by about 0.1 micrometres per second.
[[nodiscard]] MotionSegment cloth_segment(double time, const MotionState& state, double radius,
                                          double gravity, const FrictionCoefficients& law,
                                          const Vec3& pull = {0, 0, 0});

/// Whether a ball that rests on the surface begins to roll, or to slide.
[[nodiscard]] bool rolls_off(double gravity, const FrictionCoefficients& law, const Vec3& pull);

/// The segment of a ball in flight.
[[nodiscard]] MotionSegment flight_segment(double time, const MotionState& state,
                                           const Vec3& gravity);

}  // namespace carom::sim
