// Checks of debug builds on computed numbers, which find a NaN where it arises.
#pragma once

#include <cmath>

#include "core/assert.h"
#include "core/finite.h"
#include "render/geometry/ray.h"

namespace carom::render {

using carom::is_finite;

[[nodiscard]] inline bool is_finite(const V3f& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// For radiances, weights and densities.
[[nodiscard]] inline bool is_light(const V3f& v) {
    return is_finite(v) && v.x >= 0 && v.y >= 0 && v.z >= 0;
}

[[nodiscard]] inline bool is_unit(const V3f& v) {
    return is_finite(v) && std::abs(v.dot(v) - 1.0f) < 1e-3f;
}

}  // namespace carom::render
