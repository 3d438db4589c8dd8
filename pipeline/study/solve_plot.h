// Draws what a solver found.
#pragma once

#include <string>

#include "pipeline/plan/plan_colours.h"
#include "pipeline/shot/shot.h"
#include "pipeline/variants/variants.h"

namespace carom::pipeline::study {

/// A document 297 mm wide. For each strike that `solve` found: what comes of it over direction and
/// speed, with the window of directions in which it succeeds; and the table with the places where
/// the struck ball comes to rest under the player's errors. Simulates thousands of strikes.
[[nodiscard]] std::string solve_map_svg(const Shot& shot, PlanPage page,
                                        const PartsWork& work = {});

/// A document 297 mm wide: for each solution the table with the paths of its balls, the way in
/// words and its chance.
[[nodiscard]] std::string solve_plans_svg(const Shot& shot, PlanPage page,
                                          const PartsWork& work = {});

}  // namespace carom::pipeline::study
