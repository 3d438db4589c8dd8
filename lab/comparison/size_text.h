// The dependence on a size as text and as a chart.
#pragma once

#include <string>

#include "lab/comparison/size_curve.h"
#include "pipeline/plan/plan_colours.h"

namespace carom::pipeline {

/// A table for each quantity, with a row for each value and a column for each structure.
[[nodiscard]] std::string size_text(const SizeCurve& curve);

/// An SVG document: tests of objects, tests of boxes and CPU time over the size.
[[nodiscard]] std::string size_plot_svg(const SizeCurve& curve,
                                        PlanPage page = PlanPage::automatic);

}  // namespace carom::pipeline
