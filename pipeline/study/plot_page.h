// The state of the drawing of a sweep: what lines and maps share.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "pipeline/plan/plan_drawing.h"
#include "pipeline/study/plot_data.h"

namespace carom::pipeline::study {

inline constexpr std::size_t kColours = 6;         // that everyone can tell apart
inline constexpr double kPlotLeft = kMargin + 24;  // of the panels, mm

/// An axis with round ticks.
struct PlotAxis {
    double low = 0, high = 1;  // values at its ends
    double from = 0, to = 1;   // mm

    [[nodiscard]] double at(double value) const {
        return from + (to - from) * (value - low) / (high - low);
    }
    [[nodiscard]] double step() const;
    [[nodiscard]] std::vector<double> ticks() const;
    [[nodiscard]] std::string text(double value) const;
};

/// The smallest and the largest of some values.
struct PlotExtent {
    double low = 1e300, high = -1e300;

    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    /// With a little room, and with 0 where it is near.
    [[nodiscard]] PlotExtent roomy() const;
};

/// The colours of the values of a map.
struct PlotScale {
    PlotExtent values;
    std::vector<std::string> names;  // if they are names

    [[nodiscard]] std::string name_colour(std::size_t index) const;
    /// Empty where nothing was measured.
    [[nodiscard]] std::string colour(const PlotCell& cell) const;
};

/// Dashes of lines whose colours are used before.
[[nodiscard]] std::string dashes_of(std::size_t index);

class SweepPlot {
  public:
    SweepPlot(const Sweep& sweep, const SweepTable& table);

    /// Returns the whole document.
    [[nodiscard]] std::string draw(const std::string& name, PlanPage page, std::size_t rows);

  private:
    void draw_title(const std::string& name, std::size_t rows);
    /// Returns the y below it.
    [[nodiscard]] double draw_legend();
    void draw_heading(std::size_t measure, double top, const std::string& more = {});
    void draw_x_axis(const PlotAxis& axis, double top, double bottom);
    void draw_y_axis(const PlotAxis& axis, double left, double right);

    // sweep_lines.cpp: over one key
    void draw_lines(std::size_t measure, double top);
    void draw_line(const PlotSeries& one, std::size_t measure, std::size_t index,
                   const PlotAxis& across, const PlotAxis& upwards);
    /// A row of marks for each name.
    void draw_names(std::size_t measure, const PlotAxis& across, double top, double bottom);

    // sweep_map.cpp: over two keys
    void draw_map(std::size_t measure, const PlotSeries& one, double top);
    /// `colour`: empty where nothing was measured.
    void draw_dot(const Vec2& at, const std::string& colour);
    void draw_rectangle(const Vec2& low, const Vec2& high, const std::string& colour);
    void draw_upright(const std::string& text, double x, double y);
    void draw_scale(const PlotScale& scale, double top, double bottom);
    /// A colour with what it means.
    void draw_patch(double x, double y, const std::string& colour, const std::string& text);
    [[nodiscard]] PlotScale scale_of(std::size_t measure) const;
    /// The different values along an axis, ascending.
    [[nodiscard]] std::vector<double> values_along(int axis) const;

    /// The names that a measure gave, in the order of the alphabet.
    [[nodiscard]] std::vector<std::string> names_of(std::size_t measure) const;

    const Sweep& sweep_;
    PlotKeys keys_;
    std::vector<PlotSeries> series_;
    SvgText svg_;
    PlotExtent x_;  // of the first key
};

inline constexpr double kLinesHeight = 74;  // of a panel with lines, mm
inline constexpr double kMapHeight = 110;

/// "events[0].strike.speed, m/s"
[[nodiscard]] std::string axis_title(const VariedKey& key);
/// Whether it gives names, not numbers.
[[nodiscard]] bool gives_names(const Measure& measure);

}  // namespace carom::pipeline::study
