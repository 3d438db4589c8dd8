// Measured triangle kernels as a chart.
#pragma once

#include <string>

#include "lab/triangle/measure.h"
#include "pipeline/plan/plan_colours.h"

namespace carom::pipeline {

/// An SVG document, 297 mm wide: for each kernel and input, with the faster division, bars of the
/// packings side by side; random rays and the worst case, in float and in double.
[[nodiscard]] std::string kernels_plot_svg(const render::triangle::KernelMeasurements& measured,
                                           PlanPage page = PlanPage::automatic);

}  // namespace carom::pipeline
