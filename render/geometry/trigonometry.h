// Sine and cosine for sampling and rotation: Taylor polynomials on a reduced range, within 1e-7 of
// the true values, with the same bits on every machine, and several times faster than the C
// library.
#pragma once

#include "render/geometry/constants.h"
#include "render/geometry/ray.h"
#include "render/geometry/scalar_kernels.h"

namespace carom::render {

struct SinCos {
    float sine, cosine;
};

/// |angle| <= pi/4 (rad).
[[nodiscard]] inline SinCos sin_cos_eighth(float angle) {
    const auto found = scalar::sin_cos_eighth<scalar::One>(angle);
    return {found.sine, found.cosine};
}

/// Sine and cosine of 2 pi `turns`, |turns| <= 250.
[[nodiscard]] inline SinCos sin_cos_turn(float turns) {
    const auto found = scalar::sin_cos_turn<scalar::One>(turns);
    return {found.sine, found.cosine};
}

/// Sine and cosine of an angle in rad, of a few turns at most.
[[nodiscard]] inline SinCos sin_cos(float angle) {
    return sin_cos_turn(angle * (0.5f * kInversePi));
}

}  // namespace carom::render
