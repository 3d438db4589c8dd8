// What a cue stick gives a ball.
#pragma once

#include "sim/force_event.h"

namespace carom::sim {

/// Beyond this offset (in ball radii) a chalked tip slips off (Alciatore, TP 2.1).
inline constexpr double kMiscueOffset = 0.5;

struct StrikeResult {
    Vec3 velocity{0, 0, 0};          // given to the ball, world axes, m/s
    Vec3 angular_velocity{0, 0, 0};  // world axes, rad/s
};

/// Velocity and spin given to a ball of `mass` and `radius` by a stick that moves horizontally
/// along `aim` (unit, horizontal) but for its elevation. The ball goes off along the stick, turned
/// by the squirt; its spin is about axes that belong to the aim.
[[nodiscard]] StrikeResult strike_ball(const Strike& strike, const Vec3& aim, double mass,
                                       double radius);

}  // namespace carom::sim
