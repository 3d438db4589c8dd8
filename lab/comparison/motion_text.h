// The cost of motion as text and as a chart.
#pragma once

#include <string>

#include "lab/comparison/motion.h"
#include "pipeline/plan/plan_colours.h"

namespace carom::pipeline {

/// The number of rays per frame that share the cost of building in tables and charts.
inline constexpr double kRaysPerFrame = 1e6;

/// Tables with a row for each shutter time and a column for each structure and number of parts.
[[nodiscard]] std::string motion_text(const Motion& motion);

/// An SVG document over the shutter time: tests per ray, time per ray, and time per ray with its
/// share of the building.
[[nodiscard]] std::string motion_plot_svg(const Motion& motion,
                                          PlanPage page = PlanPage::automatic);

}  // namespace carom::pipeline
