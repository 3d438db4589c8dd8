// Lines of a sweep over one key.
#include "pipeline/study/plot_page.h"

namespace carom::pipeline::study {

namespace {

constexpr double kLineRight = kPageWidth - kMargin - 4;
constexpr std::size_t kMostMarks = 80;  // on a line

}  // namespace

void SweepPlot::draw_lines(std::size_t measure, double top) {
    const double bottom = top + kLinesHeight;
    draw_heading(measure, top);
    const double room = 0.01 * (x_.high - x_.low);
    const PlotAxis across{x_.low - room, x_.high + room, kPlotLeft, kLineRight};
    draw_x_axis(svg_, across, axis_title(sweep_.keys[keys_.axes[0]]), top, bottom);
    if (gives_names(sweep_.measures[measure])) {
        draw_names(measure, across, top, bottom);
        return;
    }
    PlotExtent values;
    for (const PlotSeries& one : series_) {
        for (const auto& [place, cell] : one.cells[measure]) {
            if (const std::optional<double> mean = cell.mean()) {
                const double error = cell.standard_error().value_or(0);
                values.include(*mean - error);
                values.include(*mean + error);
            }
        }
    }
    const PlotExtent range = values.roomy();
    const PlotAxis upwards{range.low, range.high, bottom, top};
    draw_y_axis(svg_, upwards, kPlotLeft, kLineRight);
    for (std::size_t i = 0; i < series_.size(); ++i) {
        draw_line(series_[i], measure, i, across, upwards);
    }
}

void SweepPlot::draw_line(const PlotSeries& one, std::size_t measure, std::size_t index,
                          const PlotAxis& across, const PlotAxis& upwards) {
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
            errors +=
                (errors.empty() ? "" : " ") +
                svg_path({{x, upwards.at(*mean - *error)}, {x, upwards.at(*mean + *error)}}, false);
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

void SweepPlot::draw_names(std::size_t measure, const PlotAxis& across, double top, double bottom) {
    const std::vector<std::string> names = names_of(measure);
    const double row = (bottom - top) / static_cast<double>(std::max<std::size_t>(names.size(), 1));
    for (std::size_t n = 0; n < names.size(); ++n) {
        const double y = bottom - (static_cast<double>(n) + 0.5) * row;
        svg_.leaf("path",
                  {{"class", "grid"}, {"d", svg_path({{kPlotLeft, y}, {kLineRight, y}}, false)}});
        svg_.text("text", names[n],
                  {{"class", "small faint end"},
                   {"x", svg_number(kPlotLeft - 1.5)},
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

}  // namespace carom::pipeline::study
