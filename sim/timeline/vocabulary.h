// The few types that every part of carom shares. SI units, right-handed, Z up.
#pragma once

#include <Imath/ImathMatrix.h>
#include <Imath/ImathQuat.h>
#include <Imath/ImathVec.h>

namespace carom {

using Vec2 = Imath::V2d;
using Vec3 = Imath::V3d;
using Quat = Imath::Quatd;  // (r, v) = (w, x y z); identity by default

/// Affine map in Imath's row-vector convention: p_world = p_body * world_from_body.
using Mat44 = Imath::M44d;

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
