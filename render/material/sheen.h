// Sheen: light scattered by fibres that stand up from a cloth, in the surface's own axes (z is the
// normal).
#pragma once

#include "render/geometry/ray.h"
#include "render/material/scalar_kernels.h"

namespace carom::render {

/// BRDF times cosine of `wi` (kernels/sheen.h). Requires `wo.z`, `wi.z` > 0. Reciprocal once
/// divided by the cosine.
[[nodiscard]] inline float sheen_reflection(const V3f& wo, const V3f& wi) {
    return scalar::sheen_reflection<scalar::One>(wo.z, wi.z, (wo + wi).length2());
}

}  // namespace carom::render
