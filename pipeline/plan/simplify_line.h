// A line of many points as one of few.
#pragma once

#include <vector>

#include "core/vectors.h"

namespace carom::pipeline {

/// Those of the points (at least one) that are needed to stay within `tolerance` of all of them;
/// the first and the last are.
[[nodiscard]] std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance);

}  // namespace carom::pipeline
