#include "pipeline/picture/line_dashes.h"

#include <algorithm>
#include <utility>

namespace carom::pipeline {
namespace {

constexpr double kDotOfDots = 1.5;  // diameter of a dotted line's dots, widths of the line
constexpr double kGap = 0.03;       // the smallest gap between dashes, m
constexpr double kLeastGap = 2.5;   // in widths of the line

/// Of the usual lengths.
double dash_scale(const SceneLine& line, const Pinhole& view) {
    constexpr double kSmallest = 0.25;
    constexpr double kLargest = 64;
    double depth = Pinhole::kNearest;
    for (const Vec3& end :
         line.reach.empty() ? std::vector{line.points.front(), line.points.back()} : line.reach) {
        depth = std::max(depth, view.depth(end));
    }
    const double gap = kGap * line.dash_size / view.pixel_size(depth);  // pixels
    const double width = line.width * view.size().y;                    // pixels
    double scale = kSmallest;
    while (scale < kLargest && scale * gap < kLeastGap * width) {
        scale *= 2;
    }
    return line.dash_size * scale;
}

StrongLine points_of(const SceneLine& line) {
    StrongLine points;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        points.push_back({line.points[i], line.strengths.empty() ? 1 : line.strengths[i]});
    }
    return points;
}

}  // namespace

std::vector<LineDash> dashes_of(const SceneLine& line, const Pinhole& view) {
    StrongLine points = points_of(line);
    if (points.size() < 2) {
        return {};
    }
    const bool is_solid = line.dash == Dash::solid;
    if (line.is_closed && !is_solid) {
        points.push_back(points.front());
    }
    std::vector<LineDash> dashes;
    for (StrongLine& dash : cut_into_dashes(points, line.dash, dash_scale(line, view))) {
        const bool is_dot = dash.size() == 1;
        const bool is_last = (dash.back().at - points.back().at).length() == 0;
        dashes.push_back({std::move(dash), is_dot ? kDotOfDots : 1, line.is_closed && is_solid,
                          is_solid || is_dot, line.has_head && is_last});
    }
    return dashes;
}

}  // namespace carom::pipeline
