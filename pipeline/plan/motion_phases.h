// Splits a track into phases of one kind of motion each, as lines on the plan.
#pragma once

#include <optional>
#include <vector>

#include "sim/timeline/timeline.h"

namespace carom::pipeline {

enum class Motion {
    at_rest,
    sliding,
    rolling,
    airborne,  // more than a millimetre above the cloth
    moving,    // an object that is not a ball
};

struct MotionPhase {
    Motion motion = Motion::at_rest;
    double from = 0, to = 0;   // scene time, s
    std::vector<Vec2> points;  // seen from above, at least two, m
};

/// The phases in order of time, without phases at rest. `radius`: of a ball; empty for other
/// objects. Motion after `end` (for example the time at which the ball was potted) is ignored.
/// Curves become polylines that stay within `tolerance` (m).
[[nodiscard]] std::vector<MotionPhase> motion_phases(const sim::Track& track,
                                                     std::optional<double> radius, double end,
                                                     double tolerance);

}  // namespace carom::pipeline
