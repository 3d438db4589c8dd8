// Line charts over a logarithmic axis, as SVG.
#pragma once

#include <string>
#include <vector>

#include "pipeline/plan/plan_colours.h"

namespace carom::pipeline {

struct ChartLine {
    std::string name;
    std::vector<Vec2> points;  // x > 0; ascending
};

struct LinePanel {
    std::string title;
    bool is_logarithmic = true;  // the vertical axis, too; otherwise it begins at 0
    std::vector<ChartLine> lines;
};

struct LineChart {
    std::string title;
    std::string explanation;
    std::string across;              // label of the x axis
    std::vector<std::string> names;  // of all lines, in the order of their colours
    std::vector<LinePanel> panels;   // from left to right
};

/// A document 297 mm wide.
[[nodiscard]] std::string line_chart_svg(const LineChart& chart, PlanPage page);

}  // namespace carom::pipeline
