// The places of repeated objects.
#pragma once

#include <vector>

#include "core/vectors.h"
#include "pipeline/config/sections/repeat.h"

namespace carom::pipeline::config {

/// One of the objects.
struct RepeatPlace {
    Vec3 position;
    double heading =
        0;  // rad, of the path's horizontal direction, from x towards y; 0 if not turned
};

/// Positions at equal distances along the path, measured by arc length (arc_length.h), from its
/// start to its end. On a closed curve, whose ends are the same point, the distance from the last
/// object to the first is the same as all others. The path was read without problems.
[[nodiscard]] std::vector<RepeatPlace> repeat_places(const RepeatSection& section);

}  // namespace carom::pipeline::config
