// The footprint of a body: its outline seen from above.
#pragma once

#include <vector>

#include "sim/world.h"

namespace carom::pipeline {

/// The convex hull of the points, counter-clockwise.
[[nodiscard]] std::vector<Vec2> convex_outline(std::vector<Vec2> points);

/// The footprint of a body at a pose; for a mesh its convex hull.
[[nodiscard]] std::vector<Vec2> footprint(const sim::BodyShape& shape, const Pose& pose);

}  // namespace carom::pipeline
