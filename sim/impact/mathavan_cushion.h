// Ball against cushion by Mathavan, Jackson and Parkin: both contacts slip while the impact lasts.
#pragma once

#include "sim/impact/ball_impact.h"

namespace carom::sim {

/// Mathavan, S., Jackson, M. R., Parkin, R. M.: A theoretical analysis of billiard ball dynamics
/// under cushion impacts, Proc. IMechE Part C: J. Mechanical Engineering Science 224(9), 1863-1873,
/// 2010. The ball, on the cloth, touches the nose and the cloth throughout. Its velocities are
/// integrated over the normal impulse at the nose, which goes on until the work of that impulse has
/// given back the share e^2 of what compression took (their equations 12 to 17). At each contact
/// Coulomb friction acts against the slip there; without slip, as much of it as keeps the slip
/// away. The paper leaves out friction there and finds it again in its next step: the same, in the
/// limit.
///
/// `normal`: unit, from the nose to the centre of the ball. `cloth_friction`: sliding, ball on
/// cloth. Changes the velocities; a ball that friction at the nose lifts has velocity.z > 0.
ImpulsePair mathavan_impact(BallBody& ball, const Vec3& normal, double restitution, double friction,
                            double cloth_friction);

}  // namespace carom::sim
