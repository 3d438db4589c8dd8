#include "pipeline/study/sweep_plot.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/core.h>

#include "core/elementary.h"
#include "core/text.h"
#include "pipeline/plan/time_axis.h"
#include "pipeline/study/plot_page.h"

namespace carom::pipeline::study {

namespace {

constexpr double kTop = 30;      // of the first panel, mm
constexpr double kBetween = 26;  // panels: the numbers and the name of an axis, and a heading
constexpr double kFurthestTicks = 22;
constexpr std::size_t kMostLines = 3 * kColours;

std::string measure_title(const Measure& measure) {
    const std::string_view unit = measure.info->unit;
    return unit.empty() || gives_names(measure) ? measure.text
                                                : measure.text + ", " + std::string(unit);
}

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

std::string axis_title(const VariedKey& key) {
    return key.unit.empty() ? key.key : key.key + ", " + key.unit;
}

bool gives_names(const Measure& measure) {
    return measure.info->unit == "name";
}

std::string dashes_of(std::size_t index) {
    return index < kColours ? "none" : (index < 2 * kColours ? "1.6 0.9" : "0.4 0.8");
}

SweepPlot::SweepPlot(const Sweep& sweep, const SweepTable& table)
    : sweep_(sweep),
      keys_(plot_keys(sweep)),
      series_(plot_series(sweep, table)),
      svg_(SvgText::Kind::fragment) {
    for (const PlotSeries& one : series_) {
        for (const auto& [place, cell] : one.cells.front()) {
            x_.include(place.first);
        }
    }
}

std::string SweepPlot::draw(const std::string& name, PlanPage page, std::size_t rows) {
    draw_title(name, rows);
    double y = kTop;
    const bool is_map = keys_.axes.size() == 2;
    if (!is_map && series_.size() > 1) {
        y = draw_legend() + 8;
    }
    for (std::size_t m = 0; m < sweep_.measures.size(); ++m) {
        if (!is_map) {
            draw_lines(m, y);
            y += kLinesHeight + kBetween;
            continue;
        }
        for (const PlotSeries& one : series_) {
            draw_map(m, one, y);
            y += kMapHeight + kBetween;
        }
    }
    return svg_page(svg_.finish(), name + ": a sweep", page, y - kBetween + 16);
}

void SweepPlot::draw_title(const std::string& name, std::size_t rows) {
    svg_.text("text", name, {{"class", "title"}, {"x", svg_number(kMargin)}, {"y", "13"}});
    std::string facts = counted(rows, "variant");
    if (keys_.averages) {
        facts += fmt::format(", means of {} with their standard errors",
                             counted(sweep_.samples, "sample"));
    }
    svg_.text("text", facts,
              {{"class", "end faint"}, {"x", svg_number(kPageWidth - kMargin)}, {"y", "13"}});
}

double SweepPlot::draw_legend() {
    double x = kMargin;
    double y = 20;
    for (std::size_t i = 0; i < series_.size(); ++i) {
        const double width = 9 + text_width(series_[i].name, 2.6);
        if (x > kMargin && x + width > kPageWidth - kMargin) {
            x = kMargin;
            y += 4.2;
        }
        svg_.leaf("path", {{"class", "path curve"},
                           {"stroke", rig_colour(i % kColours)},
                           {"stroke-dasharray", dashes_of(i)},
                           {"d", svg_path({{x, y}, {x + 5, y}}, false)}});
        svg_.text("text", series_[i].name, {{"x", svg_number(x + 6)}, {"y", svg_number(y + 0.9)}});
        x += width + 3;
    }
    return y + 2;
}

void SweepPlot::draw_heading(std::size_t measure, double top, const std::string& more) {
    const Measure& of = sweep_.measures[measure];
    const std::string title = measure_title(of) + (more.empty() ? "" : " (" + more + ")");
    svg_.text("text", title,
              {{"class", "head"}, {"x", svg_number(kMargin)}, {"y", svg_number(top - 3.5)}});
    const double x = kMargin + text_width(title, 3.1) + 4;
    svg_.text("text", fitted_text(std::string(of.info->meaning), 2.6, kPageWidth - kMargin - x),
              {{"class", "faint"}, {"x", svg_number(x)}, {"y", svg_number(top - 3.5)}});
}

void SweepPlot::draw_x_axis(const PlotAxis& axis, double top, double bottom) {
    std::string lines;
    for (const double tick : axis.ticks()) {
        const double x = axis.at(tick);
        lines += (lines.empty() ? "" : " ") + svg_path({{x, top}, {x, bottom + 1}}, false);
        svg_.text(
            "text", axis.text(tick),
            {{"class", "small faint middle"}, {"x", svg_number(x)}, {"y", svg_number(bottom + 4)}});
    }
    svg_.leaf("path", {{"class", "grid"}, {"d", lines}});
    svg_.leaf("path", {{"class", "fine"},
                       {"d", svg_path({{axis.from, bottom}, {axis.to, bottom}}, false)}});
    svg_.text("text", axis_title(sweep_.keys[keys_.axes[0]]),
              {{"class", "faint middle"},
               {"x", svg_number(0.5 * (axis.from + axis.to))},
               {"y", svg_number(bottom + 9)}});
}

void SweepPlot::draw_y_axis(const PlotAxis& axis, double left, double right) {
    std::string lines;
    for (const double tick : axis.ticks()) {
        const double y = axis.at(tick);
        lines += (lines.empty() ? "" : " ") + svg_path({{left - 1, y}, {right, y}}, false);
        svg_.text("text", axis.text(tick),
                  {{"class", "small faint end"},
                   {"x", svg_number(left - 2)},
                   {"y", svg_number(y + 0.8)}});
    }
    svg_.leaf("path", {{"class", "grid"}, {"d", lines}});
    svg_.leaf("path",
              {{"class", "fine"}, {"d", svg_path({{left, axis.from}, {left, axis.to}}, false)}});
}

std::vector<std::string> SweepPlot::names_of(std::size_t measure) const {
    std::set<std::string> names;
    for (const PlotSeries& one : series_) {
        for (const auto& [place, cell] : one.cells[measure]) {
            if (!cell.name().empty()) {
                names.insert(cell.name());
            }
        }
    }
    return {names.begin(), names.end()};
}

std::string plot_problem(const Sweep& sweep) {
    const PlotKeys keys = plot_keys(sweep);
    if (keys.axes.empty()) {
        return "no varied key has numbers, over which lines could be drawn";
    }
    if (keys.axes.size() > 2) {
        return fmt::format("a drawing has one or two keys of numbers as axes; this sweep has {}",
                           keys.axes.size());
    }
    std::size_t series = 1;
    for (const std::size_t i : keys.words) {
        series *= sweep.keys[i].points.size();
    }
    if (series > kMostLines) {
        return fmt::format("the words make {} lines; at most {} can be told apart", series,
                           kMostLines);
    }
    return {};
}

std::string sweep_plot_svg(const Sweep& sweep, const SweepTable& table, const std::string& name,
                           PlanPage page) {
    return SweepPlot(sweep, table).draw(name, page, table.rows.size());
}

}  // namespace carom::pipeline::study
