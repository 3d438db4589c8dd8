// The balls that touch a struck ball, as a group for strike_cluster().
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/scheduler/bodies.h"
#include "sim/stick/cluster_strike.h"

namespace carom::sim {

struct TouchingBalls {
    std::vector<std::uint32_t> indices;  // ascending, in Bodies
    FrozenCluster group;                 // in the same order; the struck ball's contacts come first
};

/// The ball `struck` and the balls that touch it at `time`, directly or through others. Balls that
/// approach or leave each other do not count as touching.
[[nodiscard]] TouchingBalls find_touching_balls(std::span<const MovingBody> balls,
                                                std::uint32_t struck, double time,
                                                const StaticEnvironment& environment);

}  // namespace carom::sim
