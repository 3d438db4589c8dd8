// The effect of a cue stick on a free ball.
#pragma once

#include <optional>

#include "sim/force_event.h"
#include "sim/impact/ball_impact.h"

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
    Vec3 stick{0, 0, 1};  // unit, along the stick

    /// Speed of the point that the tip touches, along the stick, m/s.
    [[nodiscard]] double point_speed(const Vec3& velocity, const Vec3& angular_velocity) const {
        return stick.dot(velocity) + lever.dot(angular_velocity);
    }
};

/// The contact of a stick's tip with a ball of `radius`. Apart from its elevation, the stick moves
/// along `aim` (unit, horizontal).
[[nodiscard]] TipContact tip_contact(const Strike& strike, const Vec3& aim, double radius);

/// Velocity and spin that the stick adds to those of a ball that touches no other: the velocity
/// changes by (1 + e) (V - v) / (1 + m/M + 5/2 b^2), with the tip's restitution e, the stick's
/// speed V, that of the struck point along the stick, v, the masses m and M of ball and stick, and
/// the offset b in ball radii; with `ball_speed`, so that the ball has this speed. Nothing if the
/// ball moves away from the stick as fast as the stick comes, or already has that speed.
[[nodiscard]] std::optional<StrikeResult> strike_ball(const Strike& strike, const Vec3& aim,
                                                      const RigidBody& ball);

}  // namespace carom::sim
