// The pose and motion of a body in SI units; world axes are right-handed with Z up.
#pragma once

#include "core/vectors.h"

namespace carom {

/// The position of a body's centre of mass in world axes, and the rotation from body axes to world
/// axes (unit quaternion).
struct Pose {
    Vec3 position{0, 0, 0};
    Quat orientation{};

    bool operator==(const Pose&) const = default;
};

/// A pose with its velocity (m/s) and angular velocity (rad/s), both in world axes.
struct MotionState {
    Vec3 position{0, 0, 0};
    Quat orientation{};
    Vec3 velocity{0, 0, 0};
    Vec3 angular_velocity{0, 0, 0};

    bool operator==(const MotionState&) const = default;
};

}  // namespace carom
