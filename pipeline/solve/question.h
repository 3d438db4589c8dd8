// What is asked of the solver: all on which its answer depends.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/hash.h"
#include "pipeline/solve/solver.h"
#include "sim/world.h"

namespace carom::pipeline::solve {

/// The version of the search, a part of every question's hash: raised when the search finds other
/// strikes, or says something else of them. (Motion has its own: sim/revision.h.)
inline constexpr std::uint64_t kSolverRevision = 2;

/// The world without the strikes after that event: the shot up to it and what it brings about.
[[nodiscard]] sim::WorldDescription without_later_strikes(sim::WorldDescription world,
                                                          std::size_t event);

struct SolveQuestion {
    sim::WorldDescription world;  // without later strikes
    SolveProblem problem;
};

/// Questions with equal hashes have equal answers.
[[nodiscard]] Hash128 hash_of(const SolveQuestion& question);

}  // namespace carom::pipeline::solve
