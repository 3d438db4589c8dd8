// A comparison as a chart.
#pragma once

#include <string>

#include "lab/comparison/comparison.h"
#include "pipeline/plan/plan_colours.h"

namespace carom::pipeline {

/// An SVG document, 297 mm wide: bars for each structure, grouped by kind of ray: object tests per
/// ray, box tests per ray, and CPU time; logarithmic.
[[nodiscard]] std::string comparison_plot_svg(const Comparison& comparison,
                                              PlanPage page = PlanPage::automatic);

}  // namespace carom::pipeline
