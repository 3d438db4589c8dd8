// One number for a choice and for what follows it.
#pragma once

#include <algorithm>

#include "render/sampling/one_minus_epsilon.h"

namespace carom::render {

/// `u` in [0, 1) decided between a part of size `share` (u < share) and the rest: where it lies
/// within what it chose, stretched to [0, 1) again. Numbers that are evenly spread stay so (Shirley
/// 1990, "Physically based lighting calculations for computer graphics", on choosing lights).
[[nodiscard]] inline float stretched(float u, float share) {
    const float v = u < share ? u / share : (u - share) / (1.0f - share);
    return std::min(v, kOneMinusEpsilon);
}

}  // namespace carom::render
