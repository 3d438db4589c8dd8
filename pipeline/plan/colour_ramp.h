// Colours for lines of things that look alike: one for each, along their row.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "pipeline/plan/plan_colours.h"

namespace carom::pipeline {

/// The things that share a paint, two at least, as places in the list that was given.
struct ColourRamp {
    std::vector<std::size_t> members;  // in their order
    bool is_warm = false;              // from purple to yellow, or from blue to red

    /// Of the member at that place in `members`.
    [[nodiscard]] std::string colour(std::size_t place) const;
    /// `share` in [0, 1]: of the way along the ramp.
    [[nodiscard]] std::string colour_at(double fraction) const;
};

struct RampEntry {
    ObjectPaint paint;
    bool is_ball = false;
};

/// Balls and other things never share a ramp; those of balls are warm.
[[nodiscard]] std::vector<ColourRamp> colour_ramps(std::span<const RampEntry> entries);

}  // namespace carom::pipeline
