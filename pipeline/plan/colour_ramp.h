// Line colours for objects that look the same: each gets its own colour of a ramp.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "pipeline/plan/plan_colours.h"

namespace carom::pipeline {

/// At least two objects of the same paint, as indices into the given list.
struct ColourRamp {
    std::vector<std::size_t> members;  // in their order
    bool is_warm = false;              // true: from purple to orange; false: from blue to red

    /// The colour of members[place].
    [[nodiscard]] std::string colour(std::size_t place) const;
    /// The colour at `fraction` of the ramp, in [0, 1].
    [[nodiscard]] std::string colour_at(double fraction) const;
};

struct RampEntry {
    ObjectPaint paint;
    bool is_ball = false;
};

/// Makes the ramps. Balls and other objects never share a ramp; the ramps of balls are warm.
[[nodiscard]] std::vector<ColourRamp> colour_ramps(std::span<const RampEntry> entries);

}  // namespace carom::pipeline
