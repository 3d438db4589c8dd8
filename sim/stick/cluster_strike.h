// A strike on a ball that touches others: the impulses of the tip and of all contacts together.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/impact/ball_impact.h"
#include "sim/stick/strike.h"

namespace carom::sim {

/// A struck ball and all balls that touch it, directly or through others.
struct FrozenCluster {
    std::vector<RigidBody> balls;
    std::size_t struck = 0;
    std::vector<TouchingPair> contacts;
};

struct ClusterStrikeResult {
    double impulse = 0;                 // of the tip, N s
    Vec3 velocity{0, 0, 0};             // change of the struck ball's, m/s
    std::vector<ImpulsePair> contacts;  // on each contact of the group
};

/// Pushes the group with the stick and changes the states of its balls. While the tip presses, the
/// balls do not rebound from each other: no contact closes, none pulls, and friction acts against
/// the slip. The tip's impulse ends when its restitution has returned e^2 of the work of its
/// compression; with `ball_speed`, when the struck ball has this speed. A group of one ball moves
/// as strike_ball() says, whose result must not be empty for the struck ball. docs/physics.md
/// derives the closed forms.
ClusterStrikeResult strike_cluster(FrozenCluster& group, const Strike& strike, const Vec3& aim,
                                   const BallBall& law);

/// Parts the pairs that were pushed, as after every impact: they separate at kMinSeparation or
/// faster.
void separate_balls(FrozenCluster& group, const ClusterStrikeResult& push);

}  // namespace carom::sim
