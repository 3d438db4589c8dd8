#include "pipeline/study/sweep_plot.h"

#include <algorithm>
#include <set>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/study/plot_page.h"

namespace carom::pipeline::study {

namespace {

constexpr double kTop = 30;      // of the first panel, mm
constexpr double kBetween = 26;  // panels: the numbers and the name of an axis, and a heading
constexpr std::size_t kMostLines = 3 * kColours;

std::string measure_title(const Measure& measure) {
    const std::string_view unit = measure.info->unit;
    return unit.empty() || gives_names(measure) ? measure.text
                                                : measure.text + ", " + std::string(unit);
}

}  // namespace

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
