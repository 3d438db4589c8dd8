// Impact of a ball with a cushion by Mathavan, Jackson and Parkin, with slip at nose and cloth.
#pragma once

#include "sim/impact/ball_impact.h"

namespace carom::sim {

/// Mathavan, S., Jackson, M. R., Parkin, R. M.: A theoretical analysis of billiard ball dynamics
/// under cushion impacts, Proc. IMechE Part C: J. Mechanical Engineering Science 224(9), 1863-1873,
/// 2010. The ball, on the cloth, touches the nose and the cloth throughout. Its velocities are
/// integrated over the normal impulse at the nose until restitution has returned the fraction e^2
/// of the work of compression (their equations 12 to 17). At each contact Coulomb friction acts
/// against the slip; without slip, friction is as large as needed to prevent slip. The paper omits
/// friction in that case and restores it in its next step, which is the same in the limit.
///
/// `normal`: unit, from the nose to the centre of the ball. `cloth_friction`: sliding friction of
/// the ball on the cloth. Changes the velocities; a ball lifted by friction at the nose has
/// velocity.z > 0.
ImpulsePair mathavan_impact(RigidBody& ball, const Vec3& normal, double restitution,
                            double friction, double cloth_friction);

}  // namespace carom::sim
