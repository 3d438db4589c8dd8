// A world that has been found fit to be simulated.
#pragma once

#include "sim/scheduler/static_environment.h"

namespace carom::sim {

/// The static part of a world, with which any number of its variants can be simulated that differ
/// in their events.
struct PreparedWorld {
    /// Throws Error with the first problem's sentence, or with what overlaps at the start.
    explicit PreparedWorld(const WorldDescription& world);

    StaticEnvironment environment;
};

/// Throws Error if an event of the world puts a ball where it cannot lie. The world must have no
/// other problems.
void require_free_places(const WorldDescription& world, const StaticEnvironment& environment);

/// Throws Error with the first of the problems, if there are any.
void require_none(const std::vector<Diagnostic>& problems);

}  // namespace carom::sim
