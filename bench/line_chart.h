// A chart with two logarithmic axes, as SVG.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace carom::bench {

struct ChartLine {
    std::string name;
    std::vector<std::pair<double, double>> points;  // > 0
};

struct Chart {
    std::string title;
    std::string x_label;
    std::string y_label;
    std::vector<ChartLine> lines;  // at most six
};

/// Throws std::runtime_error if the file cannot be written.
void write_chart(const Chart& chart, const std::string& path);

}  // namespace carom::bench
