// Sheen: light scattered by fibres that stand up from a cloth, in the surface's own axes (z is the
// normal).
#pragma once

#include <algorithm>
#include <cmath>

#include "render/geometry/ray.h"
#include "render/sampling/warp.h"

namespace carom::render {

/// BRDF times cosine of `wi`. The distribution is that of Estevez and Kulla 2017, "Production
/// friendly microfacet sheen BRDF", eq. 2, D(m) = (2 + 1/r) sin(m)^(1/r) / (2 pi) with roughness r
/// = 1/3; the visibility that of Neubelt and Pettineo 2013, "Crafting a next-gen material pipeline
/// for The Order: 1886", 1 / (4 (cos_i + cos_o - cos_i cos_o)). Requires `wo.z`, `wi.z` > 0.
/// Reciprocal once divided by the cosine.
[[nodiscard]] inline float sheen_reflection(const V3f& wo, const V3f& wi) {
    const V3f h = wo + wi;
    const float sine2 = std::max(0.0f, 1.0f - h.z * h.z / h.length2());
    const float density = 2.5f * kInversePi * sine2 * std::sqrt(sine2);
    return density * wi.z / (4.0f * (wi.z + wo.z - wi.z * wo.z));
}

}  // namespace carom::render
