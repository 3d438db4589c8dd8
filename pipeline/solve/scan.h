// Looks for strikes that meet the wants but places at rest.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/solve/strike_trials.h"

namespace carom::pipeline::solve {

/// Where strikes of a route succeed, and how their aim follows when other values change.
struct Seed {
    Setting setting;
    std::size_t target = 0;   // in StrikeTrials::targets()
    std::uint64_t cause = 0;  // of the leg of that target's ball whose miss leads the aim; 0: none
    double slope = 0;         // of that miss over the direction, m/rad
};

/// The seeds that were found, those of each route together; routes in a fixed order, those with
/// few steps first.
[[nodiscard]] std::vector<std::vector<Seed>> scan_routes(const StrikeTrials& trials);

}  // namespace carom::pipeline::solve
