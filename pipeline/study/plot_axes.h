// Axes and marks of drawings of many variants.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "pipeline/plan/plan_drawing.h"

namespace carom::pipeline::study {

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

/// With its name below the numbers; the lines go up to `top`.
void draw_x_axis(SvgText& svg, const PlotAxis& axis, const std::string& title, double top,
                 double bottom);
void draw_y_axis(SvgText& svg, const PlotAxis& axis, double left, double right);
/// The name of such an axis.
void draw_upright(SvgText& svg, const std::string& text, double x, double y);

// Empty colours are those of places where nothing was measured.
void draw_dot(SvgText& svg, const Vec2& at, const std::string& colour);
void draw_rectangle(SvgText& svg, const Vec2& low, const Vec2& high, const std::string& colour);
/// A colour with what it means.
void draw_patch(SvgText& svg, double x, double y, const std::string& colour,
                const std::string& text);

}  // namespace carom::pipeline::study
