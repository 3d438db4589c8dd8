#include "lab/comparison/line_chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lab/comparison/log_axis.h"
#include "lab/comparison/text_table.h"
#include "pipeline/plan/plan_drawing.h"
#include "pipeline/plan/time_axis.h"

namespace carom::pipeline {

namespace {

constexpr double kTop = 34;  // of the panels, mm
constexpr double kHeight = 84;
constexpr double kBottom = kTop + kHeight;
constexpr double kNumbers = 9;  // space for the numbers, left of a panel
constexpr double kBetween = 6;

// The number of colours that everyone can tell apart; further lines are dashed, then dotted.
constexpr std::size_t kColours = 6;

std::string dashes_of(std::size_t index) {
    return index < kColours ? "none" : (index < 2 * kColours ? "1.6 0.9" : "0.4 0.8");
}

/// The vertical axis: between powers of ten, or from 0 to a round number.
class Upwards {
  public:
    explicit Upwards(const LinePanel& panel)
        : is_logarithmic_(panel.is_logarithmic), axis_(kBottom, kTop) {
        double most = 0;
        for (const ChartLine& line : panel.lines) {
            for (const Vec2& point : line.points) {
                axis_.add(point.y);
                most = std::max(most, point.y);
            }
        }
        step_ = round_number(std::max(most, 1e-9) / 6);
        top_ = step_ * std::ceil(std::max(most, 1e-9) / step_);
    }
    [[nodiscard]] double at(double value) const {
        return is_logarithmic_ ? axis_.at(value) : kBottom - kHeight * value / top_;
    }
    void draw_grid(SvgText& svg, double left, double right) const {
        if (is_logarithmic_) {
            for (int power = axis_.lowest(); power <= axis_.highest(); ++power) {
                draw_line(svg, left, right, axis_.at(std::pow(10.0, power)), power_text(power));
            }
            return;
        }
        for (int i = 0; i * step_ <= top_ * (1 + 1e-9); ++i) {
            draw_line(svg, left, right, at(i * step_), svg_number(i * step_));
        }
    }

  private:
    static void draw_line(SvgText& svg, double left, double right, double y,
                          const std::string& number) {
        svg.leaf("path", {{"class", "grid"}, {"d", svg_path({{left, y}, {right, y}}, false)}});
        svg.text("text", number,
                 {{"class", "small faint end"},
                  {"x", svg_number(left - 1)},
                  {"y", svg_number(y + 0.8)}});
    }

    bool is_logarithmic_;
    LogAxis axis_;
    double step_ = 1, top_ = 1;
};

void draw_lines(SvgText& svg, const LineChart& chart, const LinePanel& panel, const LogAxis& across,
                const Upwards& upwards) {
    for (const ChartLine& line : panel.lines) {
        const auto index = static_cast<std::size_t>(std::ranges::find(chart.names, line.name) -
                                                    chart.names.begin());
        std::vector<Vec2> path;
        for (const Vec2& point : line.points) {
            path.emplace_back(across.at(point.x), upwards.at(point.y));
        }
        svg.open("g");
        svg.text("title", line.name);
        svg.leaf("path", {{"class", "path curve"},
                          {"stroke", rig_colour(index % kColours)},
                          {"stroke-dasharray", dashes_of(index)},
                          {"d", svg_path(path, false)}});
        for (const Vec2& place : path) {
            svg.leaf("circle", {{"cx", svg_number(place.x)},
                                {"cy", svg_number(place.y)},
                                {"r", "0.7"},
                                {"fill", rig_colour(index % kColours)}});
        }
        svg.close();
    }
}

void draw_panel(SvgText& svg, const LineChart& chart, const LinePanel& panel, double left,
                double right) {
    LogAxis across(left, right);
    for (const ChartLine& line : panel.lines) {
        for (const Vec2& point : line.points) {
            across.add(point.x);
        }
    }
    const Upwards upwards(panel);
    svg.text("text", panel.title,
             {{"class", "head"}, {"x", svg_number(left)}, {"y", svg_number(kTop - 3)}});
    upwards.draw_grid(svg, left, right);
    for (int power = across.lowest(); power <= across.highest(); ++power) {
        const double x = across.at(std::pow(10.0, power));
        svg.leaf("path", {{"class", "grid"}, {"d", svg_path({{x, kTop}, {x, kBottom}}, false)}});
        svg.text("text", power_text(power),
                 {{"class", "small faint middle"},
                  {"x", svg_number(x)},
                  {"y", svg_number(kBottom + 3.4)}});
    }
    svg.text("text", chart.across,
             {{"class", "faint middle"},
              {"x", svg_number(0.5 * (left + right))},
              {"y", svg_number(kBottom + 8)}});
    draw_lines(svg, chart, panel, across, upwards);
}

/// Returns how much further down the panels must be than after a legend of two lines, mm.
double draw_legend(SvgText& svg, const LineChart& chart) {
    constexpr double kFirst = 21.5;
    constexpr double kLine = 4;
    double x = kMargin;
    double y = kFirst;
    for (std::size_t i = 0; i < chart.names.size(); ++i) {
        const double width = 9 + text_width(chart.names[i], 2.6);
        if (x + width > kPageWidth - kMargin) {
            x = kMargin;
            y += kLine;
        }
        svg.leaf("path", {{"class", "path curve"},
                          {"stroke", rig_colour(i % kColours)},
                          {"stroke-dasharray", dashes_of(i)},
                          {"d", svg_path({{x, y}, {x + 5, y}}, false)}});
        svg.text("text", chart.names[i], {{"x", svg_number(x + 6)}, {"y", svg_number(y + 0.9)}});
        x += width + 2;
    }
    return std::max(0.0, y - kFirst - kLine);
}

}  // namespace

std::string line_chart_svg(const LineChart& chart, PlanPage page) {
    SvgText svg(SvgText::Kind::fragment);
    svg.text("text", chart.title, {{"class", "title"}, {"x", svg_number(kMargin)}, {"y", "11"}});
    svg.text("text", chart.explanation,
             {{"class", "faint"}, {"x", svg_number(kMargin)}, {"y", "16.5"}});
    const double lower = draw_legend(svg, chart);
    svg.open("g", {{"transform", "translate(0 " + svg_number(lower) + ")"}});
    const auto panels = static_cast<double>(chart.panels.size());
    const double width = (kPageWidth - 2 * kMargin - kBetween * (panels - 1)) / panels;
    for (std::size_t i = 0; i < chart.panels.size(); ++i) {
        const double left = kMargin + (width + kBetween) * static_cast<double>(i);
        draw_panel(svg, chart, chart.panels[i], left + kNumbers, left + width);
    }
    svg.close();
    return svg_page(svg.finish(), chart.title, page, kBottom + 14 + lower);
}

}  // namespace carom::pipeline
