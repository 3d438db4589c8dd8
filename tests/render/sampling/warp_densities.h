// The densities of the samples of render/sampling/kernels/warps.h, per unit of the measure named at
// each. They integrate to one; a density of zero means that the sampler cannot return the point.
#pragma once

#include <algorithm>

#include "render/sampling/scalar_kernels.h"

namespace carom::render {

/// Of the unit disk, per area.
[[nodiscard]] inline float pdf_disk(const V2f& p) {
    return p.length2() <= 1 ? kInversePi : 0;
}

/// Inside a regular polygon inscribed in the unit circle, per area.
[[nodiscard]] inline float pdf_polygon(int blades) {
    const float n = static_cast<float>(blades);
    return 2 / (n * scalar::sin_cos_turn<scalar::One>(1 / n).sine);
}

/// Of the hemisphere about +z, per solid angle.
[[nodiscard]] inline float pdf_cosine_hemisphere(float cos_theta) {
    return std::max(0.f, cos_theta) * kInversePi;
}

/// Inside a cone, per solid angle.
[[nodiscard]] inline float pdf_cone(float one_minus_cos) {
    return 1 / (2 * kPi * one_minus_cos);
}

/// Over [0, 1], per length.
[[nodiscard]] inline float pdf_trapezoid(float x, float switch_ratio) {
    if (x < 0 || x > 1) {
        return 0;
    }
    const float ramp = 0.5f * switch_ratio;
    const float height = 1 / (1 - ramp);
    const float edge = std::min(x, 1 - x);
    return edge < ramp ? height * edge / ramp : height;
}

}  // namespace carom::render
