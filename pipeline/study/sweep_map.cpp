// Maps of a sweep over two keys.
#include <algorithm>
#include <set>

#include <fmt/core.h>

#include "pipeline/plan/colour_ramp.h"
#include "pipeline/study/plot_page.h"

namespace carom::pipeline::study {

namespace {

constexpr double kMapRight = kPageWidth - kMargin - 52;

std::string colour_of(double fraction) {
    return ColourRamp{{}, false}.colour_at(fraction);
}

/// The edges of cells around these values.
std::vector<double> edges_of(const std::vector<double>& values) {
    std::vector<double> edges;
    for (std::size_t i = 0; i + 1 < values.size(); ++i) {
        edges.push_back(0.5 * (values[i] + values[i + 1]));
    }
    const double before = values.size() > 1 ? edges.front() - values[0] : 0.5;
    const double after = values.size() > 1 ? values.back() - edges.back() : 0.5;
    edges.insert(edges.begin(), values.front() - before);
    edges.push_back(values.back() + after);
    return edges;
}

std::size_t index_of(const std::vector<double>& values, double value) {
    return static_cast<std::size_t>(std::ranges::lower_bound(values, value) - values.begin());
}

}  // namespace

std::string PlotScale::name_colour(std::size_t index) const {
    return names.size() <= kColours
               ? rig_colour(index)
               : colour_of(static_cast<double>(index) / static_cast<double>(names.size() - 1));
}

std::string PlotScale::colour(const PlotCell& cell) const {
    if (!names.empty()) {
        const auto found = std::ranges::find(names, cell.name());
        return found == names.end() ? ""
                                    : name_colour(static_cast<std::size_t>(found - names.begin()));
    }
    const std::optional<double> mean = cell.mean();
    const double range = values.high - values.low;
    return mean ? colour_of(range > 0 ? (*mean - values.low) / range : 0.5) : "";
}

void SweepPlot::draw_map(std::size_t measure, const PlotSeries& one, double top) {
    const double bottom = top + kMapHeight;
    draw_heading(measure, top, one.name);
    const PlotScale scale = scale_of(measure);
    const bool is_scattered = sweep_.keys[keys_.axes[0]].is_sampled();
    const std::vector<double> columns = values_along(0);
    const std::vector<double> rows = values_along(1);
    const std::vector<double> x_edges = edges_of(columns);
    const std::vector<double> y_edges = edges_of(rows);
    const PlotAxis across{x_edges.front(), x_edges.back(), kPlotLeft, kMapRight};
    const PlotAxis upwards{y_edges.front(), y_edges.back(), bottom, top};
    if (is_scattered) {
        for (const auto& [place, cell] : one.cells[measure]) {
            draw_dot(svg_, {across.at(place.first), upwards.at(place.second)}, scale.colour(cell));
        }
    } else {
        svg_.leaf("rect", {{"class", "area"},
                           {"x", svg_number(kPlotLeft)},
                           {"y", svg_number(top)},
                           {"width", svg_number(kMapRight - kPlotLeft)},
                           {"height", svg_number(kMapHeight)}});
        svg_.open("g", {{"shape-rendering", "crispEdges"}});
        for (const auto& [place, cell] : one.cells[measure]) {
            const auto column = index_of(columns, place.first);
            const auto row = index_of(rows, place.second);
            // A little larger, so that rounding leaves no gap between neighbours.
            constexpr double kOverlap = 0.02;
            draw_rectangle(
                svg_, {across.at(x_edges[column]), upwards.at(y_edges[row + 1])},
                {across.at(x_edges[column + 1]) + kOverlap, upwards.at(y_edges[row]) + kOverlap},
                scale.colour(cell));
        }
        svg_.close();
    }
    draw_x_axis(svg_, across, axis_title(sweep_.keys[keys_.axes[0]]), bottom, bottom);
    draw_y_axis(svg_, upwards, kPlotLeft, kPlotLeft);
    draw_upright(svg_, axis_title(sweep_.keys[keys_.axes[1]]), kMargin + 2, 0.5 * (top + bottom));
    draw_scale(scale, top, bottom);
}

void SweepPlot::draw_scale(const PlotScale& scale, double top, double bottom) {
    const double left = kMapRight + 6;
    constexpr double kWidth = 5;
    if (!scale.names.empty()) {
        double y = top + 2;
        for (std::size_t i = 0; i < scale.names.size(); ++i, y += 5) {
            draw_patch(svg_, left, y, scale.name_colour(i), scale.names[i]);
        }
        draw_patch(svg_, left, y, "", "none");
        return;
    }
    if (scale.values.low >= scale.values.high) {
        if (scale.values.low == scale.values.high) {
            draw_patch(svg_, left, top + 2, colour_of(0.5),
                       fmt::format("{:.6g}", scale.values.low));
        }
        return;
    }
    const PlotAxis axis{scale.values.low, scale.values.high, bottom, top};
    constexpr int kSteps = 60;
    const double height = (bottom - top) / kSteps;
    svg_.open("g", {{"shape-rendering", "crispEdges"}});
    for (int i = kSteps - 1; i >= 0; --i) {  // each over the lower part of the one before
        draw_rectangle(svg_, {left, bottom - (i + 1) * height}, {left + kWidth, bottom},
                       colour_of((i + 0.5) / kSteps));
    }
    svg_.close();
    for (const double tick : axis.ticks()) {
        const double y = axis.at(tick);
        svg_.leaf("path", {{"class", "fine"},
                           {"d", svg_path({{left + kWidth, y}, {left + kWidth + 1, y}}, false)}});
        svg_.text("text", axis.text(tick),
                  {{"class", "small faint"},
                   {"x", svg_number(left + kWidth + 2)},
                   {"y", svg_number(y + 0.8)}});
    }
}

PlotScale SweepPlot::scale_of(std::size_t measure) const {
    PlotScale scale;
    scale.names = names_of(measure);
    for (const PlotSeries& one : series_) {
        for (const auto& [place, cell] : one.cells[measure]) {
            if (const std::optional<double> mean = cell.mean()) {
                scale.values.include(*mean);
            }
        }
    }
    return scale;
}

std::vector<double> SweepPlot::values_along(int axis) const {
    std::set<double> values;
    for (const PlotSeries& one : series_) {
        for (const auto& [place, cell] : one.cells.front()) {
            values.insert(axis == 0 ? place.first : place.second);
        }
    }
    return {values.begin(), values.end()};
}

}  // namespace carom::pipeline::study
