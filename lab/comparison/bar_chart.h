// Grouped bar charts as SVG.
#pragma once

#include <string>
#include <vector>

#include "pipeline/plan/plan_colours.h"

namespace carom::pipeline {

/// One quantity: for each group the values of the series, side by side. Values that are not above 0
/// are not drawn.
struct BarPanel {
    std::string title;
    std::vector<std::vector<double>> bars;  // by group, by series
    bool is_single = false;                 // one bar per group, whatever the series
    bool is_linear = false;                 // an axis from 0 instead of a logarithmic one
};

struct BarChart {
    std::string title;
    std::string explanation;
    std::vector<std::string> groups;  // from the top down
    std::vector<std::string> series;
    std::vector<BarPanel> panels;  // from left to right
};

/// A document 297 mm wide. Logarithmic axes begin and end at powers of ten.
[[nodiscard]] std::string bar_chart_svg(const BarChart& chart, PlanPage page);

}  // namespace carom::pipeline
