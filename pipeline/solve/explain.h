// Says why a search found nothing.
#pragma once

#include <string>

#include "pipeline/solve/solver.h"

namespace carom::pipeline::solve {

/// How near the search came and, of balls to be potted, why that cannot be done directly: a
/// sentence without its full stop. `world`: that of the trials.
[[nodiscard]] std::string why_unsolved(const sim::WorldDescription& world,
                                       const SolveProblem& problem, const SolveResult& result);

}  // namespace carom::pipeline::solve
