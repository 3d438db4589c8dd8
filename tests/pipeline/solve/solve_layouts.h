// Layouts with known answers, for the solver.
#pragma once

#include <string>
#include <vector>

#include "pipeline/solve/solver.h"
#include "sim/world.h"

namespace carom::pipeline::solve {

struct Layout {
    std::string name;   // "cut 35, side_front"
    std::string route;  // that the first solution has to contain; empty: any
    sim::WorldDescription world;
    SolveProblem problem;
};

/// Straight pots, cuts of 5 to 75 degrees into every pocket, banks, kicks, combinations, caroms,
/// jumps, three-cushion points, stop, follow and draw to a place, and safeties: 79 of them. The
/// 80th, a run of six pots, is solved strike by strike.
[[nodiscard]] std::vector<Layout> make_layouts();

}  // namespace carom::pipeline::solve
