// Looks for strikes that meet the wants but places at rest.
#pragma once

#include <optional>
#include <vector>

#include "pipeline/solve/strike_trials.h"

namespace carom::pipeline::solve {

/// Where strikes of a route succeed, and how their aim follows when other values change.
struct Seed {
    Setting setting;
    std::optional<Pass> pass;  // whose miss leads the aim; empty: none does
    double slope = 0;          // of that miss over the direction, m/rad
    Route route;
};

/// Two directions between which a ball passes a target on the other side.
struct Bracket {
    Pass pass;
    double low, high;
    double low_miss, high_miss;
};

/// The directions around, at one setting of the other values.
struct Scan {
    Setting setting;
    std::vector<double> directions;
    std::vector<std::optional<Sample>> samples;  // empty: not yet played
    std::vector<Bracket> brackets;
    std::vector<std::optional<std::optional<Seed>>> followed;  // of each bracket, likewise
};

/// The scans of a problem, nothing of which is played yet.
[[nodiscard]] std::vector<Scan> make_scans(const StrikeTrials& trials);

/// Plays what is not played yet and gives the seeds that were found, those of each route together;
/// routes in a fixed order, those with few steps first. Throws Stopped if the trials' work is
/// stopped; what was played is kept in `scans`.
[[nodiscard]] std::vector<std::vector<Seed>> scan_routes(const StrikeTrials& trials,
                                                         std::vector<Scan>& scans);

}  // namespace carom::pipeline::solve
