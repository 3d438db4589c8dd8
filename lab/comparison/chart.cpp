#include "lab/comparison/chart.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/core.h>

#include "lab/comparison/text_table.h"
#include "pipeline/plan/plan_drawing.h"
#include "pipeline/plan/time_axis.h"

namespace carom::pipeline {

namespace {

constexpr double kTop = 34;   // of the panels below a legend of up to two lines, mm
constexpr double kTick = 10;  // between the numbers of an axis, at least
constexpr double kFontSize = 2.6;

// Of curves:
constexpr double kHeight = 84;
constexpr double kNumbers = 9;  // space for the numbers, left of a panel
constexpr double kBetweenCurves = 6;

// Of bars:
constexpr double kRow = 2.6;
constexpr double kBetweenRows = 1.8;
constexpr double kBetweenBars = 9;
constexpr double kValue = 8;  // space for numbers next to bars

// The number of colours that everyone can tell apart; further curves are dashed, then dotted.
constexpr std::size_t kColours = 6;

using Attributes = SvgText::Attributes;

/// A stroke in the style of a curve.
Attributes stroke_of(std::size_t series, const std::vector<Vec2>& path) {
    const char* dashes =
        series < kColours ? "none" : (series < 2 * kColours ? "1.6 0.9" : "0.4 0.8");
    return {{"class", "path curve"},
            {"stroke", rig_colour(series % kColours)},
            {"stroke-dasharray", dashes},
            {"d", svg_path(path, false)}};
}

Attributes bar_of(const std::string& colour, const Vec2& place, double width, double height) {
    return {{"x", svg_number(place.x)},
            {"y", svg_number(place.y)},
            {"width", svg_number(width)},
            {"height", svg_number(height)},
            {"fill", colour}};
}

void write(SvgText& svg, const std::string& text, const char* style, double x, double y) {
    svg.text("text", text, {{"class", style}, {"x", svg_number(x)}, {"y", svg_number(y)}});
}

/// The grid lines of an axis, from one end to the other across it, and their numbers.
void draw_axis(SvgText& svg, const ChartAxis& axis, bool is_horizontal, double from, double to) {
    for (const ChartAxis::Tick& tick : axis.ticks()) {
        const Vec2 begin = is_horizontal ? Vec2(tick.at, from) : Vec2(from, tick.at);
        const Vec2 end = is_horizontal ? Vec2(tick.at, to) : Vec2(to, tick.at);
        svg.leaf("path", {{"class", "grid"}, {"d", svg_path({begin, end}, false)}});
        if (is_horizontal) {
            write(svg, tick.text, "small faint middle", tick.at, to + 3.4);
        } else {
            write(svg, tick.text, "small faint end", from - 1, tick.at + 0.8);
        }
    }
}

/// The page: titles, a legend with a symbol for each series, and the panels, which are drawn
/// further down if the legend needs more than two lines.
std::string chart_svg(const Chart& chart, PlanPage page, double height,
                      const std::function<void(SvgText&, std::size_t, const Vec2&)>& draw_symbol,
                      const std::function<void(SvgText&)>& draw_panels) {
    constexpr double kFirst = 21.5;
    constexpr double kLine = 4;
    SvgText svg(SvgText::Kind::fragment);
    write(svg, chart.title, "title", kMargin, 11);
    write(svg, chart.explanation, "faint", kMargin, 16.5);
    Vec2 at(kMargin, kFirst);
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        const double width = 9 + text_width(chart.series[i], kFontSize);
        if (at.x + width > kPageWidth - kMargin) {
            at = Vec2(kMargin, at.y + kLine);
        }
        draw_symbol(svg, i, at);
        write(svg, chart.series[i], "", at.x + 6, at.y + 0.9);
        at.x += width + 2;
    }
    const double lower = std::max(0.0, at.y - kFirst - kLine);
    svg.open("g", {{"transform", "translate(0 " + svg_number(lower) + ")"}});
    draw_panels(svg);
    svg.close();
    return svg_page(svg.finish(), chart.title, page, height + lower);
}

/// Calls `draw(panel, left, right)` for all panels, which share the page from `first` on.
void each_panel(const Chart& chart, double first, double between,
                const std::function<void(const ChartPanel&, double, double)>& draw) {
    const auto count = static_cast<double>(chart.panels.size());
    const double width = (kPageWidth - kMargin - first - between * (count - 1)) / count;
    for (const ChartPanel& panel : chart.panels) {
        draw(panel, first, first + width);
        first += width + between;
    }
}

ChartAxis axis_of(const ChartPanel& panel, double from, double to) {
    ChartAxis axis(panel.is_logarithmic, from, to);
    for (const std::vector<double>& values : panel.values) {
        std::ranges::for_each(values, [&](double value) { axis.add(value); });
    }
    return axis;
}

void draw_curves(SvgText& svg, const Chart& chart, const ChartPanel& panel,
                 const std::vector<double>& places, const ChartAxis& across) {
    const ChartAxis upwards = axis_of(panel, kTop + kHeight, kTop);
    for (std::size_t series = 0; series < chart.series.size(); ++series) {
        std::vector<Vec2> path;
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (places[i] > 0 && panel.values[i][series] > 0) {
                path.emplace_back(across.at(places[i]), upwards.at(panel.values[i][series]));
            }
        }
        if (path.empty()) {
            continue;
        }
        svg.open("g");
        svg.text("title", chart.series[series]);
        svg.leaf("path", stroke_of(series, path));
        for (const Vec2& place : path) {
            svg.leaf("circle", {{"cx", svg_number(place.x)},
                                {"cy", svg_number(place.y)},
                                {"r", "0.7"},
                                {"fill", rig_colour(series % kColours)}});
        }
        svg.close();
    }
}

void draw_bars(SvgText& svg, const ChartPanel& panel, const ChartAxis& axis, double left,
               double group_height) {
    double top = kTop;
    for (const std::vector<double>& group : panel.values) {
        const double height = panel.is_single ? std::min(group_height, 2 * kRow) : kRow;
        double y = top + (panel.is_single ? 0.5 * (group_height - height) : 0);
        for (std::size_t i = 0; i < group.size(); ++i, y += kRow) {
            if (group[i] > 0) {
                const double end = std::max(axis.at(group[i]), left + 0.3);
                svg.leaf("rect", bar_of(rig_colour(panel.is_single ? 3 : i), {left, y}, end - left,
                                        height - 0.3));
                write(svg, short_number(group[i]), "small", end + 0.8, y + 0.5 * height + 0.7);
            }
        }
        top += group_height + kBetweenRows;
    }
}

}  // namespace

void ChartAxis::add(double value) {
    if (value > 0) {
        least_ = least_ > 0 ? std::min(least_, value) : value;
        most_ = std::max(most_, value);
    }
}

int ChartAxis::lowest() const {
    return least_ > 0 ? static_cast<int>(std::floor(std::log10(least_) + 1e-9)) : 0;
}

int ChartAxis::highest() const {
    const int top = most_ > 0 ? static_cast<int>(std::ceil(std::log10(most_) - 1e-9)) : 1;
    return std::max(top, lowest() + 1);
}

double ChartAxis::step() const {
    const double length = std::abs(to_ - from_);
    return is_logarithmic_ ? std::max(1.0, std::ceil(kTick * (highest() - lowest()) / length))
                           : round_number(kTick * std::max(most_, 1e-9) / length);
}

double ChartAxis::steps() const {
    return std::ceil(std::max(most_, 1e-9) / step() - 1e-9);
}

double ChartAxis::at(double value) const {
    const double fraction = is_logarithmic_
                                ? (std::log10(value) - lowest()) / (highest() - lowest())
                                : value / (step() * steps());
    return from_ + (to_ - from_) * std::clamp(fraction, 0.0, 1.0);
}

std::vector<ChartAxis::Tick> ChartAxis::ticks() const {
    std::vector<Tick> ticks;
    if (is_logarithmic_) {
        for (int power = lowest(); power <= highest(); power += static_cast<int>(step())) {
            ticks.push_back({at(std::pow(10.0, power)), power_text(power)});
        }
        return ticks;
    }
    for (int i = 0; i <= static_cast<int>(steps()); ++i) {
        ticks.push_back({at(i * step()), fmt::format("{:g}", i * step())});
    }
    return ticks;
}

std::string line_chart_svg(const Chart& chart, const std::vector<double>& across,
                           const std::string& name_of_axis, PlanPage page) {
    constexpr double kBottom = kTop + kHeight;
    const auto draw_symbol = [](SvgText& svg, std::size_t series, const Vec2& at) {
        svg.leaf("path", stroke_of(series, {at, at + Vec2(5, 0)}));
    };
    return chart_svg(chart, page, kBottom + 14, draw_symbol, [&](SvgText& svg) {
        each_panel(chart, kMargin, kBetweenCurves,
                   [&](const ChartPanel& panel, double first, double right) {
                       const double left = first + kNumbers;
                       ChartAxis axis(true, left, right);
                       std::ranges::for_each(across, [&](double place) { axis.add(place); });
                       write(svg, panel.title, "head", left, kTop - 3);
                       draw_axis(svg, axis_of(panel, kBottom, kTop), false, left, right);
                       draw_axis(svg, axis, true, kTop, kBottom);
                       write(svg, name_of_axis, "faint middle", 0.5 * (left + right), kBottom + 8);
                       draw_curves(svg, chart, panel, across, axis);
                   });
    });
}

std::string bar_chart_svg(const Chart& chart, const std::vector<std::string>& groups,
                          PlanPage page) {
    const double height = kRow * static_cast<double>(std::max<std::size_t>(chart.series.size(), 1));
    const double bottom = kTop + (height + kBetweenRows) * static_cast<double>(groups.size());
    double widest = 0;
    for (const std::string& group : groups) {
        widest = std::max(widest, text_width(group, kFontSize));
    }
    const auto draw_symbol = [](SvgText& svg, std::size_t series, const Vec2& at) {
        svg.leaf("rect", bar_of(rig_colour(series), at - Vec2(0, 1.1), 5, 2.2));
    };
    return chart_svg(chart, page, bottom + 10, draw_symbol, [&](SvgText& svg) {
        double middle = kTop + 0.5 * height + 0.9;
        for (const std::string& group : groups) {
            write(svg, group, "end", kMargin + widest + 1, middle);
            middle += height + kBetweenRows;
        }
        each_panel(chart, kMargin + widest + 3, kBetweenBars,
                   [&](const ChartPanel& panel, double left, double right) {
                       const ChartAxis axis = axis_of(panel, left, right - kValue);
                       write(svg, panel.title, "head", left, kTop - 3);
                       draw_axis(svg, axis, true, kTop - 1, bottom);
                       draw_bars(svg, panel, axis, left, height);
                   });
    });
}

std::string power_text(int exponent) {
    if (exponent < 0) {
        return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + "1";
    }
    const std::string zeros(static_cast<std::size_t>(exponent % 3), '0');
    const char* prefix = exponent < 3 ? "" : exponent < 6 ? "k" : exponent < 9 ? "M" : "G";
    return exponent < 12 ? "1" + zeros + prefix : fmt::format("1e{}", exponent);
}

}  // namespace carom::pipeline
