// A line of time across the page, and numbers of events on it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "pipeline/plan/plan_drawing.h"

namespace carom::pipeline {

inline constexpr double kAxisLeft = kMargin + 16;  // where it begins, mm; its name is before that
inline constexpr double kAxisRight = kPageWidth - kMargin - 4;

struct TimeAxis {
    double from = 0, to = 1;  // s

    [[nodiscard]] double at(double time) const {
        return kAxisLeft + (kAxisRight - kAxisLeft) * (time - from) / std::max(to - from, 1e-9);
    }
    /// Where its ticks are: round times, at most twelve steps.
    [[nodiscard]] std::vector<double> ticks() const;
};

/// The least of 1, 2 or 5 times a power of ten that is not below `least` (> 0).
[[nodiscard]] double round_number(double least);

/// The line at `y` (mm) with ticks and times below it.
void draw_time_axis(SvgText& svg, const TimeAxis& axis, double y, const std::string& name);

/// Numbers above a line, in up to three rows that begin at `y`; returns where the line is.
[[nodiscard]] double draw_event_marks(SvgText& svg, const TimeAxis& axis,
                                      const std::vector<NumberedEvent>& events, double y);

}  // namespace carom::pipeline
