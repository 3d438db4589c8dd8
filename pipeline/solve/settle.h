// Finds the best setting of a route.
#pragma once

#include <functional>
#include <vector>

#include "pipeline/solve/scan.h"
#include "pipeline/solve/solver.h"

namespace carom::pipeline::solve {

/// A setting in which the wants but places at rest are met, and what came of it.
struct Played {
    Setting setting;
    sim::Outcome outcome;
};

/// What is known of a route.
struct KnownRoute {
    std::vector<Seed> seeds;  // at least one
    bool is_fine = false;     // over 110 points of the grid instead of 25
    std::vector<Played> played;
    std::size_t tried = 0;  // of the seeds and then of the grid
};

/// Other speeds and tips than those of the seeds are tried over a grid, the aim following by the
/// secant method, then by a pattern search, until balls rest where they are wanted; of what meets
/// all wants, the setting with the best chance and preferences is taken. Calls `found` at once with
/// each better setting that meets all wants, with `tells_nearest` also with the nearest so far; its
/// window and chance are not yet known. Throws Stopped if the trials' work is stopped; what was
/// played over the grid is kept in `route`.
[[nodiscard]] Solution settle(const StrikeTrials& trials, KnownRoute& route, bool tells_nearest,
                              const std::function<void(const Solution&)>& found);

/// What comes of a setting: its route, window and chance.
[[nodiscard]] Solution judge(const StrikeTrials& trials, const Setting& setting);

}  // namespace carom::pipeline::solve
