// A segment of a ball's motion on which both accelerations are constant.
#pragma once

#include <limits>

#include "core/pose.h"

namespace carom::sim {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

enum class MotionKind {
    sliding,   // on a level surface, slipping
    rolling,   // on a level surface, without slip
    spinning,  // on a level surface, turning about the vertical only
    resting,   // still
    flying,    // touching nothing
    stepped,   // in touch with more than a level surface: carried by ODE
};

/// Holds from `start` to `end`; `end` is when the law of motion changes by itself (sliding ends,
/// the ball stops), kNever if it does not.
struct MotionSegment {
    MotionKind kind = MotionKind::resting;
    double start = 0;  // scene time, s
    double end = kNever;
    MotionState state;                   // at `start`
    Vec3 acceleration{0, 0, 0};          // m/s^2
    Vec3 angular_acceleration{0, 0, 0};  // rad/s^2

    [[nodiscard]] Vec3 position_at(double time) const;
    [[nodiscard]] Vec3 velocity_at(double time) const;
    [[nodiscard]] Vec3 angular_velocity_at(double time) const;
    /// All of it, with the orientation (which costs most).
    [[nodiscard]] MotionState state_at(double time) const;
};

}  // namespace carom::sim
