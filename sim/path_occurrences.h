// Finds what happens on the paths of a timeline: crossings of a line, apexes and rests.
#pragma once

#include <vector>

#include "core/vectors.h"
#include "sim/timeline/timeline.h"
#include "sim/world.h"

namespace carom::sim {

/// The scene times (s), in order, at which the object's centre, seen from above, passes through the
/// line segment between two different points (m) from one side to the other. An object that starts
/// on the line does not cross it by leaving.
[[nodiscard]] std::vector<double> line_crossings(const Track& track, const Vec2& from,
                                                 const Vec2& to);

/// The scene times (s), in order, at which the object stops to rise after it rose by at least
/// kMinRise.
[[nodiscard]] std::vector<double> apexes(const Track& track);

/// The scene times (s), in order, at which the object comes to rest after a visible motion
/// (RestDetector).
[[nodiscard]] std::vector<double> rests(const Track& track);

/// The scene times (s), in order, at which all bodies of the world rest after some of them moved.
[[nodiscard]] std::vector<double> rests_of_all(const Timeline& timeline,
                                               const WorldDescription& world);

}  // namespace carom::sim
