// The way of an object as a line of short straight pieces.
#pragma once

#include <vector>

#include "sim/timeline/track.h"

namespace carom::pipeline {

struct LinePoint {
    Vec3 position{0, 0, 0};  // m
    double time = 0;         // scene time, s
};

/// The positions during [from, to] (from <= to): the first, the last, and so many between them that
/// the line deviates from the way by less than half a millimetre. While the object rests it has two
/// points.
[[nodiscard]] std::vector<LinePoint> track_line(const sim::Track& track, double from, double to);

}  // namespace carom::pipeline
