// Growth for people.
#pragma once

#include <string>

#include "lab/comparison/growth.h"
#include "pipeline/plan/plan_colours.h"

namespace carom::pipeline {

/// Over numbers of shapes, a column for each structure: tests per ray, time of a ray, building,
/// memory.
[[nodiscard]] std::string growth_text(const Growth& growth);

/// An SVG document: tests per ray, both ways logarithmic; those of trees with only the number of
/// shapes so, where a logarithm is a straight line; and the time of a ray.
[[nodiscard]] std::string growth_plot_svg(const Growth& growth,
                                          PlanPage page = PlanPage::automatic);

/// "spheres", "mesh"
[[nodiscard]] const char* name_of(GrowingScene scene);

}  // namespace carom::pipeline
