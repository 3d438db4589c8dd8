// Ball against cushion, by one of the published models.
#pragma once

#include "sim/impact/ball_impact.h"

namespace carom::sim {

/// A ball at the cushion: `inward` is the horizontal unit normal into the playing field,
/// `contact_normal` the unit vector from the nose to the ball's centre (it points down for a nose
/// above the centre). Changes the ball's velocities; the model's vertical part is kept as computed.
ImpulsePair cushion_impact(BallBody& ball, const Vec3& inward, const Vec3& contact_normal,
                           const ContactLaw& law);

}  // namespace carom::sim
