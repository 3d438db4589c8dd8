// Says what a strike brings about, and why a search found nothing.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/solve/solver.h"

namespace carom::pipeline::solve {

/// The wanted measures with that strike: their titles and values; empty: it does not happen.
[[nodiscard]] std::vector<std::pair<std::string, std::optional<double>>> measured_values(
    const sim::WorldDescription& world, const SolveProblem& problem, const sim::Strike& strike);

/// How near the search came and, of balls to be potted, why that cannot be done directly: a
/// sentence without its full stop. `world`: that of the trials.
[[nodiscard]] std::string why_unsolved(const sim::WorldDescription& world,
                                       const SolveProblem& problem, const SolveResult& result);

}  // namespace carom::pipeline::solve
