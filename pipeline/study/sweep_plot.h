// Draws what a sweep measured.
#pragma once

#include <string>

#include "pipeline/plan/plan_colours.h"
#include "pipeline/study/sweep.h"

namespace carom::pipeline::study {

/// Why a sweep cannot be drawn; empty if it can.
[[nodiscard]] std::string plot_problem(const Sweep& sweep);

/// A document 297 mm wide with a panel for each measure: lines over one key of numbers, a map over
/// two. Keys of words become lines, or panels of maps. Sampled keys are averaged over where others
/// have steps. `name`: of the shot.
[[nodiscard]] std::string sweep_plot_svg(const Sweep& sweep, const SweepTable& table,
                                         const std::string& name, PlanPage page);

}  // namespace carom::pipeline::study
