// Where a body is and how it moves. SI units, world axes right-handed with Z up.
#pragma once

#include "core/vectors.h"

namespace carom {

/// Where a body is: `position` of its centre of mass in world axes, and the rotation that turns
/// body axes into world axes (unit quaternion).
struct Pose {
    Vec3 position{0, 0, 0};
    Quat orientation{};

    bool operator==(const Pose&) const = default;
};

/// A pose and how it changes. Both velocities are in world axes; angular velocity in rad/s.
struct MotionState {
    Vec3 position{0, 0, 0};
    Quat orientation{};
    Vec3 velocity{0, 0, 0};
    Vec3 angular_velocity{0, 0, 0};

    bool operator==(const MotionState&) const = default;
};

}  // namespace carom
