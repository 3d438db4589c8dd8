// The effect of a cue stick on a free ball.
#pragma once

#include "sim/force_event.h"

namespace carom::sim {

/// Beyond this offset (in ball radii) a chalked tip slips off (Alciatore, TP 2.1).
inline constexpr double kMiscueOffset = 0.5;

struct StrikeResult {
    Vec3 velocity{0, 0, 0};          // added to the ball's, world axes, m/s
    Vec3 angular_velocity{0, 0, 0};  // world axes, rad/s
};

/// How an impulse of the tip acts on the ball. World axes.
struct TipContact {
    Vec3 direction{0, 0, 1};  // unit, of the impulse: along the stick, turned by the squirt
    Vec3 lever{0, 0, 0};  // angular impulse per impulse, m: the squirt does not deflect the spin
};

/// The contact of a stick's tip with a ball of `radius`. Apart from its elevation, the stick moves
/// along `aim` (unit, horizontal).
[[nodiscard]] TipContact tip_contact(const Strike& strike, const Vec3& aim, double radius);

/// Velocity and spin that the stick gives to a ball of `mass` and `radius` that touches no other:
/// the ball's speed is (1 + e) V / (1 + m/M + 5/2 b^2), with the tip's restitution e, the stick's
/// speed V, the masses m and M of ball and stick, and the offset b in ball radii.
[[nodiscard]] StrikeResult strike_ball(const Strike& strike, const Vec3& aim, double mass,
                                       double radius);

}  // namespace carom::sim
