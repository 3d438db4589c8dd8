// The two ways of a ball on cloth: that of its centre, and that of its lowest point over the cloth.
#pragma once

#include "sim/timeline/track.h"
#include "sound/rolling/way.h"

namespace carom::sound {

struct BallWays {
    Way rolled;  // by the speed of the centre, |v|
    Way slid;    // by the slip speed, |v + w x r|, r from the centre to the lowest point
};

/// The ways of a ball between two scene times (from < to) of its track. Vertical motion does not
/// count. The pieces end at all keys and are at most 10 ms long (more in stretches of over ten
/// minutes, so that there are never more than 65536 and one for each key). The pressures
/// are those of rolling_level.h.
[[nodiscard]] BallWays ball_ways(const sim::Track& track, double radius, double from, double to);

/// The speeds of both ways of a ball with these velocities.
struct BallSpeeds {
    double rolled = 0;  // m/s
    double slid = 0;
};
[[nodiscard]] BallSpeeds ball_speeds(const Vec3& velocity, const Vec3& angular_velocity,
                                     double radius);

}  // namespace carom::sound
