#include "pipeline/plan/time_axis.h"

#include <array>
#include <cmath>

#include <fmt/core.h>

#include "pipeline/plan/quantity_text.h"

namespace carom::pipeline {

namespace {

constexpr double kBadge = 1.5;  // radius of an event's number
constexpr int kMostRows = 3;    // of numbers, one above the other

/// The row of each number. Numbers that would overlap get different rows; if all rows are full,
/// only the tick is drawn.
std::vector<int> rows_of(const std::vector<NumberedEvent>& events, const TimeAxis& axis) {
    std::array<double, kMostRows> taken{};
    std::vector<int> rows;
    for (const NumberedEvent& event : events) {
        const double x = axis.at(event.time);
        std::size_t row = 0;
        while (row < taken.size() && taken.at(row) > x - 2 * kBadge) {
            ++row;
        }
        if (row < taken.size()) {
            taken.at(row) = x;
        }
        rows.push_back(static_cast<int>(row));
    }
    return rows;
}

void draw_mark(SvgText& svg, const NumberedEvent& event, double x, double y, int row) {
    const bool has_room = row < kMostRows;
    const double top = has_room ? y - 1.2 - 2 * kBadge * (row + 0.5) : y - 1.2;
    svg.leaf("path", {{"class", "fine"}, {"d", svg_path({{x, y}, {x, top}}, false)}});
    if (!has_room) {
        return;
    }
    svg.leaf("circle", {{"class", "badge"},
                        {"cx", svg_number(x)},
                        {"cy", svg_number(top)},
                        {"r", svg_number(kBadge)}});
    svg.text("text", fmt::format("{}", event.number),
             {{"class", "number"},
              {"x", svg_number(x)},
              {"y", svg_number(top + 0.66)},
              {"style", "font-size:1.8px"}});
}

}  // namespace

double round_number(double least) {
    const double decade = std::pow(10, std::floor(std::log10(std::max(least, 1e-9))));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * decade >= least * (1 - 1e-9)) {
            return step * decade;
        }
    }
    return 10 * decade;
}

std::vector<double> TimeAxis::ticks() const {
    std::vector<double> times;
    const double step = round_number(std::max((to - from) / 12, 1e-6));
    for (int i = 0; i * step <= (to - from) * (1 + 1e-9); ++i) {
        times.push_back(from + i * step);
    }
    return times;
}

void draw_time_axis(SvgText& svg, const TimeAxis& axis, double y, const std::string& name) {
    svg.text("text", name,
             {{"class", "head"}, {"x", svg_number(kMargin)}, {"y", svg_number(y + 0.9)}});
    svg.leaf("path",
             {{"class", "fine"}, {"d", svg_path({{kAxisLeft, y}, {kAxisRight, y}}, false)}});
    for (const double time : axis.ticks()) {
        const double x = axis.at(time);
        svg.leaf("path", {{"class", "fine"}, {"d", svg_path({{x, y}, {x, y + 1}}, false)}});
        svg.text(
            "text", time_text(time),
            {{"class", "small faint middle"}, {"x", svg_number(x)}, {"y", svg_number(y + 3.3)}});
    }
}

double draw_event_marks(SvgText& svg, const TimeAxis& axis,
                        const std::vector<NumberedEvent>& events, double y) {
    const std::vector<int> rows = rows_of(events, axis);
    const int highest = rows.empty() ? 0 : *std::max_element(rows.begin(), rows.end());
    const double line = y + 1.4 + 2 * kBadge * std::min(highest + 1, kMostRows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        draw_mark(svg, events[i], axis.at(events[i].time), line, rows[i]);
    }
    return line;
}

}  // namespace carom::pipeline
