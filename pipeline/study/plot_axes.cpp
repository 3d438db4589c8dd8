#include "pipeline/study/plot_axes.h"

#include <cmath>

#include <fmt/core.h>

#include "core/elementary.h"
#include "core/text.h"
#include "pipeline/plan/time_axis.h"

namespace carom::pipeline::study {

namespace {

constexpr double kFurthestTicks = 22;

}  // namespace

double PlotAxis::step() const {
    return round_number((high - low) * kFurthestTicks / 2 / std::abs(to - from));
}

std::vector<double> PlotAxis::ticks() const {
    std::vector<double> values;
    const double distance = step();
    const auto first = static_cast<long>(std::ceil(low / distance - 1e-9));
    for (long i = first; static_cast<double>(i) * distance <= high + 1e-9 * distance; ++i) {
        values.push_back(static_cast<double>(i) * distance);
    }
    return values;
}

std::string PlotAxis::text(double value) const {
    const int decimals =
        std::max(0, -static_cast<int>(std::floor(logarithm(step()) / logarithm(10) + 1e-9)));
    return decimals > 6 ? fmt::format("{:.3g}", value) : decimal_text(value, decimals);
}

PlotExtent PlotExtent::roomy() const {
    if (low > high) {
        return {0, 1};
    }
    if (low == high) {
        const double room = low == 0 ? 1 : 0.1 * std::abs(low);
        return {low - room, high + room};
    }
    const double room = 0.05 * (high - low);
    const bool is_near_zero = low >= 0 && low < 0.4 * high;
    return {is_near_zero ? (low == 0 ? -room : 0) : low - room, high + room};
}

void draw_x_axis(SvgText& svg, const PlotAxis& axis, const std::string& title, double top,
                 double bottom) {
    std::string lines;
    for (const double tick : axis.ticks()) {
        const double x = axis.at(tick);
        lines += (lines.empty() ? "" : " ") + svg_path({{x, top}, {x, bottom + 1}}, false);
        svg.text(
            "text", axis.text(tick),
            {{"class", "small faint middle"}, {"x", svg_number(x)}, {"y", svg_number(bottom + 4)}});
    }
    svg.leaf("path", {{"class", "grid"}, {"d", lines}});
    svg.leaf("path",
             {{"class", "fine"}, {"d", svg_path({{axis.from, bottom}, {axis.to, bottom}}, false)}});
    svg.text("text", title,
             {{"class", "faint middle"},
              {"x", svg_number(0.5 * (axis.from + axis.to))},
              {"y", svg_number(bottom + 9)}});
}

void draw_y_axis(SvgText& svg, const PlotAxis& axis, double left, double right) {
    std::string lines;
    for (const double tick : axis.ticks()) {
        const double y = axis.at(tick);
        lines += (lines.empty() ? "" : " ") + svg_path({{left - 1, y}, {right, y}}, false);
        svg.text("text", axis.text(tick),
                 {{"class", "small faint end"},
                  {"x", svg_number(left - 2)},
                  {"y", svg_number(y + 0.8)}});
    }
    svg.leaf("path", {{"class", "grid"}, {"d", lines}});
    svg.leaf("path",
             {{"class", "fine"}, {"d", svg_path({{left, axis.from}, {left, axis.to}}, false)}});
}

void draw_dot(SvgText& svg, const Vec2& at, const std::string& colour) {
    SvgText::Attributes dot{{"cx", svg_number(at.x)}, {"cy", svg_number(at.y)}, {"r", "0.8"}};
    dot.emplace_back(colour.empty() ? "class" : "fill", colour.empty() ? "area" : colour);
    svg.leaf("circle", dot);
}

void draw_rectangle(SvgText& svg, const Vec2& low, const Vec2& high, const std::string& colour) {
    if (!colour.empty()) {
        svg.leaf("rect", {{"x", svg_number(low.x)},
                          {"y", svg_number(low.y)},
                          {"width", svg_number(high.x - low.x)},
                          {"height", svg_number(high.y - low.y)},
                          {"fill", colour}});
    }
}

void draw_upright(SvgText& svg, const std::string& text, double x, double y) {
    svg.text("text", text,
             {{"class", "faint middle"},
              {"transform", "translate(" + svg_point({x, y}) + ") rotate(-90)"}});
}

void draw_patch(SvgText& svg, double x, double y, const std::string& colour,
                const std::string& text) {
    SvgText::Attributes patch{
        {"x", svg_number(x)}, {"y", svg_number(y - 1.5)}, {"width", "4"}, {"height", "3"}};
    patch.emplace_back(colour.empty() ? "class" : "fill", colour.empty() ? "area" : colour);
    svg.leaf("rect", patch);
    svg.text("text", text, {{"x", svg_number(x + 6)}, {"y", svg_number(y + 0.9)}});
}

}  // namespace carom::pipeline::study
