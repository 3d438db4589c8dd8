// What is asked of the solver: all on which its answer depends.
#pragma once

#include "core/hash.h"
#include "pipeline/solve/solver.h"
#include "sim/world.h"

namespace carom::pipeline::solve {

struct SolveQuestion {
    sim::WorldDescription world;  // without later strikes
    SolveProblem problem;
};

/// Questions with equal hashes have equal answers.
[[nodiscard]] Hash128 hash_of(const SolveQuestion& question);

}  // namespace carom::pipeline::solve
