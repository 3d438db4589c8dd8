// Impact of a ball with a cushion, by one of the published models.
#pragma once

#include "sim/impact/ball_impact.h"

namespace carom::sim {

/// `inward`: the horizontal unit normal into the playing area; `contact_normal`: the unit vector
/// from the nose to the ball's centre (it points down for a nose above the centre). The restitution
/// is that for the ball's speed along `inward`, in every model. `cloth_friction`: sliding friction
/// of the ball on the cloth. Changes the ball's velocities; the vertical part is kept as the model
/// computes it.
ImpulsePair cushion_impact(RigidBody& ball, const Vec3& inward, const Vec3& contact_normal,
                           const BallCushion& cushion, double cloth_friction);

}  // namespace carom::sim
