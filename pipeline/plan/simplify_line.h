// Simplifies polylines.
#pragma once

#include <vector>

#include "core/vectors.h"

namespace carom::pipeline {

/// A subset of the points (at least one) whose polyline stays within `tolerance` of all points. It
/// contains the first and the last point.
[[nodiscard]] std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance);

}  // namespace carom::pipeline
