#include "pipeline/study/sweep_plot.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/plan/colour_ramp.h"
#include "pipeline/plan/plan_drawing.h"
#include "pipeline/plan/time_axis.h"
#include "pipeline/study/plot_data.h"

namespace carom::pipeline::study {

namespace {

constexpr double kTop = 30;         // of the first panel, mm
constexpr double kLineHeight = 74;  // of a panel with lines
constexpr double kMapHeight = 110;  // of a map
constexpr double kBetween = 26;     // panels: the numbers and the name of an axis, and a heading
constexpr double kLeft = kMargin + 24;
constexpr double kLineRight = kPageWidth - kMargin - 4;
constexpr double kMapRight = kPageWidth - kMargin - 52;
constexpr double kFurthestTicks = 22;  // mm
constexpr std::size_t kColours = 6;
constexpr std::size_t kMostLines = 3 * kColours;
constexpr std::size_t kMostMarks = 80;  // on a line

/// An axis with round ticks.
struct Axis {
    double low = 0, high = 1;  // values at its ends
    double from = 0, to = 1;   // mm

    [[nodiscard]] double at(double value) const {
        return from + (to - from) * (value - low) / (high - low);
    }
    [[nodiscard]] double step() const {
        return round_number((high - low) * kFurthestTicks / 2 / std::abs(to - from));
    }
    [[nodiscard]] std::vector<double> ticks() const {
        std::vector<double> values;
        const double distance = step();
        const auto first = static_cast<long>(std::ceil(low / distance - 1e-9));
        for (long i = first; static_cast<double>(i) * distance <= high + 1e-9 * distance; ++i) {
            values.push_back(static_cast<double>(i) * distance);
        }
        return values;
    }
    [[nodiscard]] std::string text(double value) const {
        const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step()) + 1e-9)));
        return decimals > 6 ? fmt::format("{:.3g}", value) : decimal_text(value, decimals);
    }
};

/// The smallest and the largest of some values.
struct Extent {
    double low = 1e300, high = -1e300;

    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    /// With a little room, and with 0 where it is near.
    [[nodiscard]] Extent roomy() const {
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
};

std::string axis_title(const VariedKey& key) {
    return key.unit.empty() ? key.key : key.key + ", " + key.unit;
}

std::string measure_title(const Measure& measure) {
    const std::string_view unit = measure.info->unit;
    return unit.empty() || unit == "name" ? measure.text : measure.text + ", " + std::string(unit);
}

bool is_name(const Measure& measure) {
    return measure.info->unit == "name";
}

std::string colour_of(double fraction) {
    return ColourRamp{{}, false}.colour_at(fraction);
}

std::string dashes_of(std::size_t index) {
    return index < kColours ? "none" : (index < 2 * kColours ? "1.6 0.9" : "0.4 0.8");
}

/// The state of the drawing of a sweep.
class SweepPlot {
  public:
    SweepPlot(const Sweep& sweep, const SweepTable& table)
        : sweep_(sweep),
          keys_(plot_keys(sweep)),
          series_(plot_series(sweep, table)),
          svg_(SvgText::Kind::fragment) {
        Extent x;
        Extent y;
        for (const PlotSeries& one : series_) {
            for (const auto& [place, cell] : one.cells.front()) {
                x.include(place.first);
                y.include(place.second);
            }
        }
        x_ = x;
        y_ = y;
    }

    /// Returns the whole document.
    std::string draw(const std::string& name, PlanPage page, std::size_t rows) {
        draw_title(name, rows);
        double y = kTop;
        const bool is_map = keys_.axes.size() == 2;
        if (!is_map && series_.size() > 1) {
            y = draw_legend() + 8;
        }
        for (std::size_t m = 0; m < sweep_.measures.size(); ++m) {
            if (!is_map) {
                draw_lines(m, y);
                y += kLineHeight + kBetween;
                continue;
            }
            for (const PlotSeries& one : series_) {
                draw_map(m, one, y);
                y += kMapHeight + kBetween;
            }
        }
        return svg_page(svg_.finish(), name + ": a sweep", page, y - kBetween + 16);
    }

  private:
    void draw_title(const std::string& name, std::size_t rows) {
        svg_.text("text", name, {{"class", "title"}, {"x", svg_number(kMargin)}, {"y", "13"}});
        std::string facts = counted(rows, "variant");
        if (keys_.averages) {
            facts += fmt::format(", means of {} with their standard errors",
                                 counted(sweep_.samples, "sample"));
        }
        svg_.text("text", facts,
                  {{"class", "end faint"}, {"x", svg_number(kPageWidth - kMargin)}, {"y", "13"}});
    }

    /// Returns the y below it.
    double draw_legend() {
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
            svg_.text("text", series_[i].name,
                      {{"x", svg_number(x + 6)}, {"y", svg_number(y + 0.9)}});
            x += width + 3;
        }
        return y + 2;
    }

    void draw_heading(std::size_t measure, double top, const std::string& more = {}) {
        const Measure& of = sweep_.measures[measure];
        const std::string title = measure_title(of) + (more.empty() ? "" : " (" + more + ")");
        svg_.text("text", title,
                  {{"class", "head"}, {"x", svg_number(kMargin)}, {"y", svg_number(top - 3.5)}});
        const double x = kMargin + text_width(title, 3.1) + 4;
        svg_.text("text", fitted_text(std::string(of.info->meaning), 2.6, kPageWidth - kMargin - x),
                  {{"class", "faint"}, {"x", svg_number(x)}, {"y", svg_number(top - 3.5)}});
    }

    void draw_x_axis(const Axis& axis, double top, double bottom) {
        std::string lines;
        for (const double tick : axis.ticks()) {
            const double x = axis.at(tick);
            lines += (lines.empty() ? "" : " ") + svg_path({{x, top}, {x, bottom + 1}}, false);
            svg_.text("text", axis.text(tick),
                      {{"class", "small faint middle"},
                       {"x", svg_number(x)},
                       {"y", svg_number(bottom + 4)}});
        }
        svg_.leaf("path", {{"class", "grid"}, {"d", lines}});
        svg_.leaf("path", {{"class", "fine"},
                           {"d", svg_path({{axis.from, bottom}, {axis.to, bottom}}, false)}});
        svg_.text("text", axis_title(sweep_.keys[keys_.axes[0]]),
                  {{"class", "faint middle"},
                   {"x", svg_number(0.5 * (axis.from + axis.to))},
                   {"y", svg_number(bottom + 9)}});
    }

    void draw_y_axis(const Axis& axis, double left, double right,
                     const std::function<std::string(double)>& text_of) {
        std::string lines;
        for (const double tick : axis.ticks()) {
            const double y = axis.at(tick);
            lines += (lines.empty() ? "" : " ") + svg_path({{left - 1, y}, {right, y}}, false);
            svg_.text("text", text_of(tick),
                      {{"class", "small faint end"},
                       {"x", svg_number(left - 2)},
                       {"y", svg_number(y + 0.8)}});
        }
        svg_.leaf("path", {{"class", "grid"}, {"d", lines}});
        svg_.leaf("path", {{"class", "fine"},
                           {"d", svg_path({{left, axis.from}, {left, axis.to}}, false)}});
    }

    /// The names that a measure gave, in the order of the alphabet.
    [[nodiscard]] std::vector<std::string> names_of(std::size_t measure) const {
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

    // Lines over one key

    void draw_lines(std::size_t measure, double top) {
        const double bottom = top + kLineHeight;
        draw_heading(measure, top);
        const double room = 0.01 * (x_.high - x_.low);
        const Axis across{x_.low - room, x_.high + room, kLeft, kLineRight};
        draw_x_axis(across, top, bottom);
        if (is_name(sweep_.measures[measure])) {
            draw_names(measure, across, top, bottom);
            return;
        }
        Extent values;
        for (const PlotSeries& one : series_) {
            for (const auto& [place, cell] : one.cells[measure]) {
                if (const std::optional<double> mean = cell.mean()) {
                    const double error = cell.standard_error().value_or(0);
                    values.include(*mean - error);
                    values.include(*mean + error);
                }
            }
        }
        const Extent range = values.roomy();
        const Axis upwards{range.low, range.high, bottom, top};
        draw_y_axis(upwards, kLeft, kLineRight, [&](double v) { return upwards.text(v); });
        for (std::size_t i = 0; i < series_.size(); ++i) {
            draw_line(series_[i], measure, i, across, upwards);
        }
    }

    void draw_line(const PlotSeries& one, std::size_t measure, std::size_t index,
                   const Axis& across, const Axis& upwards) {
        const std::string colour = rig_colour(index % kColours);
        const bool is_scattered = sweep_.keys[keys_.axes[0]].is_sampled();
        std::string path;
        std::string errors;
        std::vector<Vec2> piece;
        std::vector<Vec2> marks;
        const auto end_piece = [&] {
            if (piece.size() > 1 && !is_scattered) {
                path += (path.empty() ? "" : " ") + svg_path(piece, false);
            }
            piece.clear();
        };
        for (const auto& [place, cell] : one.cells[measure]) {
            const std::optional<double> mean = cell.mean();
            if (!mean) {
                end_piece();
                continue;
            }
            const double x = across.at(place.first);
            const Vec2 at(x, upwards.at(*mean));
            piece.push_back(at);
            marks.push_back(at);
            if (const std::optional<double> error = cell.standard_error()) {
                errors += (errors.empty() ? "" : " ") + svg_path({{x, upwards.at(*mean - *error)},
                                                                  {x, upwards.at(*mean + *error)}},
                                                                 false);
            }
        }
        end_piece();
        svg_.open("g");
        svg_.text("title", one.name.empty() ? sweep_.measures[measure].text : one.name);
        if (!errors.empty()) {
            svg_.leaf("path", {{"class", "path"},
                               {"stroke", colour},
                               {"style", "stroke-width:.3;stroke-opacity:.6"},
                               {"d", errors}});
        }
        if (!path.empty()) {
            svg_.leaf("path", {{"class", "path curve"},
                               {"stroke", colour},
                               {"stroke-dasharray", dashes_of(index)},
                               {"d", path}});
        }
        if (is_scattered || marks.size() <= kMostMarks) {
            for (const Vec2& at : marks) {
                svg_.leaf("circle", {{"cx", svg_number(at.x)},
                                     {"cy", svg_number(at.y)},
                                     {"r", is_scattered ? "0.45" : "0.7"},
                                     {"fill", colour}});
            }
        }
        svg_.close();
    }

    /// A row of marks for each name.
    void draw_names(std::size_t measure, const Axis& across, double top, double bottom) {
        const std::vector<std::string> names = names_of(measure);
        const double row =
            (bottom - top) / static_cast<double>(std::max<std::size_t>(names.size(), 1));
        for (std::size_t n = 0; n < names.size(); ++n) {
            const double y = bottom - (static_cast<double>(n) + 0.5) * row;
            svg_.leaf("path",
                      {{"class", "grid"}, {"d", svg_path({{kLeft, y}, {kLineRight, y}}, false)}});
            svg_.text("text", names[n],
                      {{"class", "small faint end"},
                       {"x", svg_number(kLeft - 1.5)},
                       {"y", svg_number(y + 0.8)}});
            const double lane = std::min(2.0, row / static_cast<double>(series_.size() + 1));
            for (std::size_t i = 0; i < series_.size(); ++i) {
                const double shift =
                    (static_cast<double>(i) - 0.5 * static_cast<double>(series_.size() - 1)) * lane;
                for (const auto& [place, cell] : series_[i].cells[measure]) {
                    if (cell.name() == names[n]) {
                        svg_.leaf("circle", {{"cx", svg_number(across.at(place.first))},
                                             {"cy", svg_number(y + shift)},
                                             {"r", "0.7"},
                                             {"fill", rig_colour(i % kColours)}});
                    }
                }
            }
        }
    }

    // Maps over two keys

    /// The edges of cells around these values.
    static std::vector<double> edges_of(const std::vector<double>& values) {
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

    /// The value and the colours of a map.
    struct Scale {
        Extent values;
        std::vector<std::string> names;

        [[nodiscard]] std::string name_colour(std::size_t index) const {
            return names.size() <= kColours ? rig_colour(index)
                                            : colour_of(static_cast<double>(index) /
                                                        static_cast<double>(names.size() - 1));
        }
        [[nodiscard]] std::string colour(const PlotCell& cell) const {
            if (!names.empty()) {
                const auto found = std::ranges::find(names, cell.name());
                return found == names.end()
                           ? ""
                           : name_colour(static_cast<std::size_t>(found - names.begin()));
            }
            const std::optional<double> mean = cell.mean();
            const double range = values.high - values.low;
            return mean ? colour_of(range > 0 ? (*mean - values.low) / range : 0.5) : "";
        }
    };

    [[nodiscard]] Scale scale_of(std::size_t measure) const {
        Scale scale;
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

    void draw_map(std::size_t measure, const PlotSeries& one, double top) {
        const double bottom = top + kMapHeight;
        draw_heading(measure, top, one.name);
        const Scale scale = scale_of(measure);
        const bool is_scattered = sweep_.keys[keys_.axes[0]].is_sampled();
        const std::vector<double> columns = values_along(0);
        const std::vector<double> rows = values_along(1);
        const std::vector<double> x_edges = edges_of(columns);
        const std::vector<double> y_edges = edges_of(rows);
        const Axis across{x_edges.front(), x_edges.back(), kLeft, kMapRight};
        const Axis upwards{y_edges.front(), y_edges.back(), bottom, top};
        if (is_scattered) {
            for (const auto& [place, cell] : one.cells[measure]) {
                draw_dot({across.at(place.first), upwards.at(place.second)}, scale.colour(cell));
            }
        } else {
            svg_.leaf("rect", {{"class", "area"},
                               {"x", svg_number(kLeft)},
                               {"y", svg_number(top)},
                               {"width", svg_number(kMapRight - kLeft)},
                               {"height", svg_number(kMapHeight)}});
            svg_.open("g", {{"shape-rendering", "crispEdges"}});
            for (const auto& [place, cell] : one.cells[measure]) {
                const auto column = index_of(columns, place.first);
                const auto row = index_of(rows, place.second);
                // A little larger, so that rounding leaves no gap between neighbours.
                constexpr double kOverlap = 0.02;
                draw_rectangle({across.at(x_edges[column]), upwards.at(y_edges[row + 1])},
                               {across.at(x_edges[column + 1]) + kOverlap,
                                upwards.at(y_edges[row]) + kOverlap},
                               scale.colour(cell));
            }
            svg_.close();
        }
        draw_x_axis(across, bottom, bottom);
        draw_y_axis(upwards, kLeft, kLeft, [&](double v) { return upwards.text(v); });
        draw_upright(axis_title(sweep_.keys[keys_.axes[1]]), kMargin + 2, 0.5 * (top + bottom));
        draw_scale(scale, top, bottom);
    }

    /// `colour`: empty where nothing was measured.
    void draw_dot(const Vec2& at, const std::string& colour) {
        SvgText::Attributes dot{{"cx", svg_number(at.x)}, {"cy", svg_number(at.y)}, {"r", "0.8"}};
        dot.emplace_back(colour.empty() ? "class" : "fill", colour.empty() ? "area" : colour);
        svg_.leaf("circle", dot);
    }

    void draw_rectangle(const Vec2& low, const Vec2& high, const std::string& colour) {
        if (!colour.empty()) {
            svg_.leaf("rect", {{"x", svg_number(low.x)},
                               {"y", svg_number(low.y)},
                               {"width", svg_number(high.x - low.x)},
                               {"height", svg_number(high.y - low.y)},
                               {"fill", colour}});
        }
    }

    void draw_upright(const std::string& text, double x, double y) {
        svg_.text("text", text,
                  {{"class", "faint middle"},
                   {"transform", "translate(" + svg_point({x, y}) + ") rotate(-90)"}});
    }

    void draw_scale(const Scale& scale, double top, double bottom) {
        const double left = kMapRight + 6;
        constexpr double kWidth = 5;
        if (!scale.names.empty()) {
            double y = top + 2;
            for (std::size_t i = 0; i < scale.names.size(); ++i, y += 5) {
                draw_patch(left, y, scale.name_colour(i), scale.names[i]);
            }
            draw_patch(left, y, "", "none");
            return;
        }
        if (scale.values.low >= scale.values.high) {
            if (scale.values.low == scale.values.high) {
                draw_patch(left, top + 2, colour_of(0.5), fmt::format("{:.6g}", scale.values.low));
            }
            return;
        }
        const Axis axis{scale.values.low, scale.values.high, bottom, top};
        constexpr int kSteps = 60;
        const double height = (bottom - top) / kSteps;
        svg_.open("g", {{"shape-rendering", "crispEdges"}});
        for (int i = kSteps - 1; i >= 0; --i) {  // each over the lower part of the one before
            draw_rectangle({left, bottom - (i + 1) * height}, {left + kWidth, bottom},
                           colour_of((i + 0.5) / kSteps));
        }
        svg_.close();
        for (const double tick : axis.ticks()) {
            const double y = axis.at(tick);
            svg_.leaf("path",
                      {{"class", "fine"},
                       {"d", svg_path({{left + kWidth, y}, {left + kWidth + 1, y}}, false)}});
            svg_.text("text", axis.text(tick),
                      {{"class", "small faint"},
                       {"x", svg_number(left + kWidth + 2)},
                       {"y", svg_number(y + 0.8)}});
        }
    }

    /// A colour with what it means.
    void draw_patch(double x, double y, const std::string& colour, const std::string& text) {
        SvgText::Attributes patch{
            {"x", svg_number(x)}, {"y", svg_number(y - 1.5)}, {"width", "4"}, {"height", "3"}};
        patch.emplace_back(colour.empty() ? "class" : "fill", colour.empty() ? "area" : colour);
        svg_.leaf("rect", patch);
        svg_.text("text", text, {{"x", svg_number(x + 6)}, {"y", svg_number(y + 0.9)}});
    }

    /// The different values along an axis, ascending.
    [[nodiscard]] std::vector<double> values_along(int axis) const {
        std::set<double> values;
        for (const PlotSeries& one : series_) {
            for (const auto& [place, cell] : one.cells.front()) {
                values.insert(axis == 0 ? place.first : place.second);
            }
        }
        return {values.begin(), values.end()};
    }

    static std::size_t index_of(const std::vector<double>& values, double value) {
        return static_cast<std::size_t>(std::ranges::lower_bound(values, value) - values.begin());
    }

    const Sweep& sweep_;
    PlotKeys keys_;
    std::vector<PlotSeries> series_;
    SvgText svg_;
    Extent x_, y_;
};

}  // namespace

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
