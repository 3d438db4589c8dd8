// The two ways of a ball on cloth: that of its centre, and that of its lowest point over the cloth.
#pragma once

#include <span>

#include "sim/timeline/track.h"
#include "sound/rolling/way.h"

namespace carom::sound {

struct BallWays {
    Way rolled;  // by the speed of the centre, |v|
    Way slid;    // by the slip speed, |v + w x r|, r from the centre to the lowest point
};

/// A contact of a ball with another thing.
struct Touch {
    double time = 0;      // scene time, s, at which it begins
    double duration = 0;  // s, > 0
};

/// The ways of a ball between two scene times (from < to) of its track. Vertical motion does not
/// count. In the track an impact changes the ball's velocity at once; here its speeds change, by
/// the smooth step, over the contact with which the impact is among `touches` (in order of time),
/// or over 1 ms if it is not. The pieces end at all keys, and are at most 10 ms long and a quarter
/// of a contact during it (more in stretches of over ten minutes, so that there are never more than
/// 65536, one for each key and five for each contact). The pressures are those of rolling_level.h.
[[nodiscard]] BallWays ball_ways(const sim::Track& track, double radius, double from, double to,
                                 std::span<const Touch> touches);

/// Multiplies the pressures by the factors of the dynamics with this ratio (decibels.h), of what
/// both ways make together. Pieces of the same index are at the same time, unless a way has none.
void apply_dynamics(double ratio, BallWays& ways);

/// The speeds of both ways of a ball with these velocities.
struct BallSpeeds {
    double rolled = 0;  // m/s
    double slid = 0;
};
[[nodiscard]] BallSpeeds ball_speeds(const Vec3& velocity, const Vec3& angular_velocity,
                                     double radius);

}  // namespace carom::sound
