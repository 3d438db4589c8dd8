// Finds the best setting of a route.
#pragma once

#include <vector>

#include "pipeline/solve/scan.h"
#include "pipeline/solve/solver.h"

namespace carom::pipeline::solve {

/// From the seeds of a route: other speeds and tips are tried over a grid, the aim following by the
/// secant method, then by a pattern search, until balls rest where they are wanted; of what meets
/// all wants, the setting with the best chance and preferences is taken. `is_fine`: over 110 points
/// of the grid instead of 25.
[[nodiscard]] Solution settle(const StrikeTrials& trials, const std::vector<Seed>& seeds,
                              bool is_fine);

}  // namespace carom::pipeline::solve
