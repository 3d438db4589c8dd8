// Torque-free rotation of a rigid body.
#pragma once

#include "core/pose.h"

namespace carom::sim {

struct RotationalState {
    Quat orientation;                // body axes are the principal ones
    Vec3 angular_velocity{0, 0, 0};  // world axes, rad/s
};

/// The rotation `duration` later. Implicit midpoint rule for the body angular momentum with the
/// Cayley map for the orientation (Austin, Krishnaprasad, Wang: Almost Poisson integration of rigid
/// body systems, J. Comp. Phys. 107, 1993, section 4): energy and angular momentum are kept to
/// round-off whatever the step, the phase to second order in substeps of at most 0.05 rad.
/// `inertia`: principal moments, kg m^2.
[[nodiscard]] RotationalState rotate_freely(const RotationalState& from, const Vec3& inertia,
                                            double duration);

/// The state of a body `duration` later, without forces or torques.
[[nodiscard]] MotionState drift(const MotionState& from, const Vec3& inertia, double duration);

}  // namespace carom::sim
