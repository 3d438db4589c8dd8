#include "lab/comparison/bar_chart.h"

#include <algorithm>
#include <cmath>

#include "lab/comparison/log_axis.h"
#include "lab/comparison/text_table.h"
#include "pipeline/plan/plan_drawing.h"

namespace carom::pipeline {

namespace {

constexpr double kTop = 31;  // of the bars, mm
constexpr double kRow = 2.6;
constexpr double kBetweenRows = 1.8;
constexpr double kBetweenPanels = 9;
constexpr double kValue = 8;  // space for numbers next to bars

struct Layout {
    double left = 0, width = 0;  // of a panel
    double row = 0;              // distance between groups
};

double height_of_group(const BarChart& chart) {
    return kRow * static_cast<double>(std::max<std::size_t>(chart.series.size(), 1));
}

/// An axis from 0 to a round number.
class LinearAxis {
  public:
    LinearAxis(double from, double to, double most) : from_(from), to_(to) {
        const double power = std::pow(10.0, std::floor(std::log10(std::max(most, 1e-9))));
        for (const double step : {0.25, 0.5, 1.0, 2.5}) {
            step_ = step * power;
            if (step_ * kSteps >= most) {
                break;
            }
        }
    }
    static constexpr int kSteps = 4;
    [[nodiscard]] double step() const { return step_; }
    [[nodiscard]] double at(double value) const {
        return from_ + (to_ - from_) * value / (step_ * kSteps);
    }

  private:
    double from_, to_;
    double step_ = 1;
};

void draw_grid_line(SvgText& svg, double x, double bottom, const std::string& text) {
    svg.leaf("path", {{"class", "grid"}, {"d", svg_path({{x, kTop - 1}, {x, bottom}}, false)}});
    svg.text(
        "text", text,
        {{"class", "small faint middle"}, {"x", svg_number(x)}, {"y", svg_number(bottom + 3.2)}});
}

void draw_grid(SvgText& svg, const LogAxis& axis, double bottom) {
    const int step = std::max(1, (axis.highest() - axis.lowest() + 5) / 6);
    for (int power = axis.lowest(); power <= axis.highest(); power += step) {
        draw_grid_line(svg, axis.at(std::pow(10.0, power)), bottom, power_text(power));
    }
}

void draw_grid(SvgText& svg, const LinearAxis& axis, double bottom) {
    for (int i = 0; i <= LinearAxis::kSteps; ++i) {
        const double value = i * axis.step();
        draw_grid_line(svg, axis.at(value), bottom, short_number(value));
    }
}

void draw_panel(SvgText& svg, const BarChart& chart, const BarPanel& panel, const Layout& layout,
                double left) {
    const double right = left + layout.width - kValue;
    LogAxis axis(left, right);
    double most = 0;
    for (const std::vector<double>& group : panel.bars) {
        for (const double value : group) {
            axis.add(value);
            most = std::max(most, value);
        }
    }
    const double bottom = kTop + layout.row * static_cast<double>(chart.groups.size());
    svg.text("text", panel.title,
             {{"class", "head"}, {"x", svg_number(left)}, {"y", svg_number(kTop - 3.5)}});
    const LinearAxis linear(left, right, most);
    panel.is_linear ? draw_grid(svg, linear, bottom) : draw_grid(svg, axis, bottom);
    const double all = height_of_group(chart);
    for (std::size_t group = 0; group < panel.bars.size(); ++group) {
        const std::vector<double>& bars = panel.bars[group];
        for (std::size_t i = 0; i < bars.size(); ++i) {
            if (bars[i] <= 0) {
                continue;
            }
            const double height = panel.is_single ? std::min(all, 2 * kRow) : kRow;
            const double indent = panel.is_single ? 0.5 * (all - height) : 0;
            const double y = kTop + layout.row * static_cast<double>(group) + indent +
                             kRow * static_cast<double>(i);
            const double at = panel.is_linear ? linear.at(bars[i]) : axis.at(bars[i]);
            const double end = std::max(at, left + 0.3);
            svg.leaf("rect", {{"x", svg_number(left)},
                              {"y", svg_number(y)},
                              {"width", svg_number(end - left)},
                              {"height", svg_number(height - 0.3)},
                              {"fill", panel.is_single ? rig_colour(3) : rig_colour(i)}});
            svg.text("text", short_number(bars[i]),
                     {{"class", "small"},
                      {"x", svg_number(end + 0.8)},
                      {"y", svg_number(y + 0.5 * height + 0.7)}});
        }
    }
}

void draw_legend(SvgText& svg, const BarChart& chart) {
    double x = kMargin;
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        svg.leaf("rect", {{"x", svg_number(x)},
                          {"y", svg_number(20.4)},
                          {"width", "3"},
                          {"height", "2.2"},
                          {"fill", rig_colour(i)}});
        svg.text("text", chart.series[i], {{"x", svg_number(x + 4)}, {"y", svg_number(22.4)}});
        x += 8 + text_width(chart.series[i], 2.6);
    }
}

}  // namespace

std::string bar_chart_svg(const BarChart& chart, PlanPage page) {
    SvgText svg(SvgText::Kind::fragment);
    svg.text("text", chart.title, {{"class", "title"}, {"x", svg_number(kMargin)}, {"y", "11"}});
    svg.text("text", chart.explanation,
             {{"class", "faint"}, {"x", svg_number(kMargin)}, {"y", "16.5"}});
    draw_legend(svg, chart);
    double names = 0;
    for (const std::string& group : chart.groups) {
        names = std::max(names, text_width(group, 2.6));
    }
    const double left = kMargin + names + 3;
    const auto panels = static_cast<double>(chart.panels.size());
    Layout layout;
    layout.row = height_of_group(chart) + kBetweenRows;
    layout.width = (kPageWidth - kMargin - left - kBetweenPanels * (panels - 1)) / panels;
    for (std::size_t i = 0; i < chart.groups.size(); ++i) {
        const double y =
            kTop + layout.row * static_cast<double>(i) + 0.5 * height_of_group(chart) + 0.9;
        svg.text("text", chart.groups[i],
                 {{"class", "end"}, {"x", svg_number(left - 2)}, {"y", svg_number(y)}});
    }
    for (std::size_t i = 0; i < chart.panels.size(); ++i) {
        draw_panel(svg, chart, chart.panels[i], layout,
                   left + (layout.width + kBetweenPanels) * static_cast<double>(i));
    }
    const double height = kTop + layout.row * static_cast<double>(chart.groups.size()) + 10;
    return svg_page(svg.finish(), chart.title, page, height);
}

}  // namespace carom::pipeline
