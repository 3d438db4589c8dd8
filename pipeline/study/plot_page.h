// The state of the drawing of a sweep: what lines and maps share.
#pragma once

#include <string>
#include <vector>

#include "pipeline/plan/plan_drawing.h"
#include "pipeline/study/plot_axes.h"
#include "pipeline/study/plot_data.h"

namespace carom::pipeline::study {

inline constexpr std::size_t kColours = 6;  // that everyone can tell apart

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

    // sweep_lines.cpp: over one key
    void draw_lines(std::size_t measure, double top);
    void draw_line(const PlotSeries& one, std::size_t measure, std::size_t index,
                   const PlotAxis& across, const PlotAxis& upwards);
    /// A row of marks for each name.
    void draw_names(std::size_t measure, const PlotAxis& across, double top, double bottom);

    // sweep_map.cpp: over two keys
    void draw_map(std::size_t measure, const PlotSeries& one, double top);
    void draw_scale(const PlotScale& scale, double top, double bottom);
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
