// Balls that start inside of what does not move.
#pragma once

#include <string>
#include <vector>

#include "sim/billiards/table.h"
#include "sim/world.h"

namespace carom::sim {

struct StartOverlap {
    std::string ball;
    std::string other;  // "the cloth", "a cushion", "a rail", "a pocket", "the floor" or "'ramp'"
    double depth = 0;   // how far the ball reaches into it, m

    /// "reaches 3.20 mm into a cushion"
    [[nodiscard]] std::string sentence() const;
};

/// The moving balls of a world without other problems that overlap something at the start by more
/// than round-off, each with what it reaches into farthest: neither a touch nor a way out could be
/// found for them. `table`: the world's geometry (all parts or those collided with); nullptr if it
/// has none or no cushions. Balls in each other are `find_problems`'.
[[nodiscard]] std::vector<StartOverlap> find_start_overlaps(const WorldDescription& world,
                                                            const billiards::TableGeometry* table);

}  // namespace carom::sim
