// What a body covers, seen from above.
#pragma once

#include <vector>

#include "sim/world.h"

namespace carom::pipeline {

/// The smallest convex outline around the points, counter-clockwise.
[[nodiscard]] std::vector<Vec2> convex_outline(std::vector<Vec2> points);

/// The outline of a body at a pose; of a mesh the convex one.
[[nodiscard]] std::vector<Vec2> footprint(const sim::BodyShape& shape, const Pose& pose);

}  // namespace carom::pipeline
