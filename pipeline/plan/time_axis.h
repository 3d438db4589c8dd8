// A time axis across the page, with the numbers of events.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "pipeline/plan/plan_drawing.h"

namespace carom::pipeline {

inline constexpr double kAxisLeft = kMargin + 16;  // mm; the axis's name is to the left of it
inline constexpr double kAxisRight = kPageWidth - kMargin - 4;

struct TimeAxis {
    double from = 0, to = 1;  // s

    [[nodiscard]] double at(double time) const {
        return kAxisLeft + (kAxisRight - kAxisLeft) * (time - from) / std::max(to - from, 1e-9);
    }
    /// The ticks: round times, with at most twelve intervals.
    [[nodiscard]] std::vector<double> ticks() const;
};

/// The smallest of 1, 2 or 5 times a power of ten that is at least `least` (> 0).
[[nodiscard]] double round_number(double least);

/// Draws the axis at `y` (mm) with ticks and times below it.
void draw_time_axis(SvgText& svg, const TimeAxis& axis, double y, const std::string& name);

/// Draws event numbers in up to three rows that begin at `y`, above the axis; returns the y of the
/// axis.
[[nodiscard]] double draw_event_marks(SvgText& svg, const TimeAxis& axis,
                                      const std::vector<NumberedEvent>& events, double y);

}  // namespace carom::pipeline
