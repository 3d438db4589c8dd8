// Charts as SVG: panels side by side, with curves or with bars.
#pragma once

#include <string>
#include <vector>

#include "pipeline/plan/plan_colours.h"

namespace carom::pipeline {

/// An axis between whole powers of ten, or from 0 to a round number.
class ChartAxis {
  public:
    /// Positions of the ends on the page, mm.
    ChartAxis(bool is_logarithmic, double from, double to)
        : is_logarithmic_(is_logarithmic), from_(from), to_(to) {}

    /// Includes the value. Values that are not above 0 are ignored.
    void add(double value);
    [[nodiscard]] double at(double value) const;

    struct Tick {
        double at;
        std::string text;
    };
    /// As many as have room.
    [[nodiscard]] std::vector<Tick> ticks() const;

  private:
    [[nodiscard]] int lowest() const;  // exponents of the ends
    [[nodiscard]] int highest() const;
    [[nodiscard]] double step() const;   // between ticks
    [[nodiscard]] double steps() const;  // of a linear axis

    bool is_logarithmic_;
    double from_, to_;
    double least_ = 0, most_ = 0;
};

/// One quantity. Values that are not above 0 are not drawn.
struct ChartPanel {
    std::string title;
    bool is_logarithmic = true;
    std::vector<std::vector<double>> values;  // by place, then by series
    bool is_single = false;                   // one bar to a place, whatever the series
};

struct Chart {
    std::string title, explanation;
    std::vector<std::string> series;  // in the order of their colours
    std::vector<ChartPanel> panels;   // from left to right
};

/// A document 297 mm wide, with a curve for each series. `across`: the places, on a logarithmic
/// axis; those that are not above 0 are left out.
[[nodiscard]] std::string line_chart_svg(const Chart& chart, const std::vector<double>& across,
                                         const std::string& name_of_axis, PlanPage page);

/// The same with a bar for each series, in groups from the top down, which are the places.
[[nodiscard]] std::string bar_chart_svg(const Chart& chart, const std::vector<std::string>& groups,
                                        PlanPage page);

/// 10 to the power of `exponent`: "0.01", "1", "10k", "100M".
[[nodiscard]] std::string power_text(int exponent);

}  // namespace carom::pipeline
