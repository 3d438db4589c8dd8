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
    resting,   // at rest
    flying,    // without contact
    stepped,   // in contact with more than a level surface: stepped by ODE
};

/// Valid from `start` to `end`, when the law of motion changes without an impact (sliding ends, the
/// ball stops); `end` is kNever if it does not change.
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
    /// The complete state, including the orientation, which costs most.
    [[nodiscard]] MotionState state_at(double time) const;
};

}  // namespace carom::sim
