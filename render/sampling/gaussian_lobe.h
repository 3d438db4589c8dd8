// Gaussian lobes: directions whose angle from an axis is normally distributed (gloss and
// translucency of Cook, Porter and Carpenter 1984, "Distributed ray tracing"). They are sampled by
// kernels/gaussian_lobe.h.
#pragma once

#include <numbers>

#include "core/elementary_float.h"
#include "render/geometry/constants.h"

namespace carom::render {

/// The probability that |x| <= pi / 2 for a normally distributed x of standard deviation `spread`
/// (rad, > 0).
[[nodiscard]] inline float gaussian_within_a_quarter_turn(float spread) {
    return error_function(0.5f * kPi / (std::numbers::sqrt2_v<float> * spread));
}

}  // namespace carom::render
