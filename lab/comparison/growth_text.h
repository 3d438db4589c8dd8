// Growth as text and as a chart.
#pragma once

#include <string>

#include "lab/comparison/growth.h"
#include "pipeline/plan/plan_colours.h"

namespace carom::pipeline {

/// Over numbers of shapes, one column per structure: tests per ray, time per ray, build time,
/// memory.
[[nodiscard]] std::string growth_text(const Growth& growth);

/// An SVG document: tests per ray with both axes logarithmic; those of trees with a logarithmic
/// horizontal axis only, on which a logarithm is a straight line; and the time per ray.
[[nodiscard]] std::string growth_plot_svg(const Growth& growth,
                                          PlanPage page = PlanPage::automatic);

/// "spheres", "mesh"
[[nodiscard]] const char* name_of(GrowingScene scene);

}  // namespace carom::pipeline
