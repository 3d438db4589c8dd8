// A track cut into pieces of one kind of motion each, as lines on the plan.
#pragma once

#include <optional>
#include <vector>

#include "sim/timeline/timeline.h"

namespace carom::pipeline {

enum class Motion {
    still,
    sliding,
    rolling,
    airborne,  // more than a millimetre from the cloth
    moving,    // of what is no ball
};

struct MotionPhase {
    Motion motion = Motion::at_rest;
    double from = 0, to = 0;   // scene time, s
    std::vector<Vec2> points;  // seen from above, at least two, m
};

/// In order of time, without those in which it stands still. `radius`: of a ball. Nothing after
/// `end` (where it was potted, say). Curves become lines that stay within `tolerance` (m).
[[nodiscard]] std::vector<MotionPhase> motion_phases(const sim::Track& track,
                                                     std::optional<double> radius, double end,
                                                     double tolerance);

}  // namespace carom::pipeline
