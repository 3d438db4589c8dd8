// The effect of a cue stick on a ball.
#pragma once

#include "sim/force_event.h"

namespace carom::sim {

/// Beyond this offset (in ball radii) a chalked tip slips off (Alciatore, TP 2.1).
inline constexpr double kMiscueOffset = 0.5;

struct StrikeResult {
    Vec3 velocity{0, 0, 0};          // added to the ball's, world axes, m/s
    Vec3 angular_velocity{0, 0, 0};  // world axes, rad/s
};

/// Velocity and spin that a stick gives to a ball of `mass` and `radius`. Apart from its elevation,
/// the stick moves along `aim` (unit, horizontal). The ball leaves along the stick, deflected by
/// the squirt; its spin is not deflected.
[[nodiscard]] StrikeResult strike_ball(const Strike& strike, const Vec3& aim, double mass,
                                       double radius);

}  // namespace carom::sim
