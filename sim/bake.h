// The one entry to the simulation.
#pragma once

#include <string>
#include <vector>

#include "sim/timeline/hash.h"
#include "sim/timeline/progress.h"
#include "sim/timeline/timeline.h"
#include "sim/world.h"

namespace carom::sim {

struct BakeResult {
    Timeline timeline;
    std::vector<std::string> warnings;  // a strike that misses, a miscue, a loop's cap reached ...
    /// For each of these the event of the description that it is about, by index; -1: none.
    std::vector<int> warned_events;
};

/// Simulates the whole shot. Deterministic: the same description gives the same timeline, bit for
/// bit. May run on several threads at once, one world each. Throws Error on a description with
/// problems, Stopped when stopped.
[[nodiscard]] BakeResult bake(const WorldDescription& world, const WorkContext& context = {});

/// Hash of everything in the description that can change the bake, and of the simulation's own
/// revision number.
[[nodiscard]] Hash128 physics_hash(const WorldDescription& world);

}  // namespace carom::sim
