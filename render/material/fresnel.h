// How much light a smooth boundary reflects.
#pragma once

#include <algorithm>
#include <cmath>

#include "render/geometry/ray.h"

namespace carom::render {

/// Unpolarised reflectance of a boundary between dielectrics, seen from outside (Born and Wolf,
/// "Principles of Optics", 7th ed. 1999, section 1.5.2, eq. 21 a and b, their squares' mean).
/// `cosine`: of the angle of incidence, [0, 1]; `ior`: relative index, >= 1. In [0, 1].
[[nodiscard]] inline float fresnel_dielectric(float cosine, float ior) {
    const float cos_i = std::min(cosine, 1.0f);
    const float sin2_t = (1.0f - cos_i * cos_i) / (ior * ior);
    const float cos_t = std::sqrt(std::max(0.0f, 1.0f - sin2_t));
    const float parallel = (ior * cos_i - cos_t) / (ior * cos_i + cos_t);
    const float perpendicular = (cos_i - ior * cos_t) / (cos_i + ior * cos_t);
    return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

/// Reflectance of a metal whose reflectance straight on is `f0` (Schlick 1994, "An inexpensive BRDF
/// model for physically-based rendering", eq. 15).
[[nodiscard]] inline V3f fresnel_schlick(float cosine, const V3f& f0) {
    const float rest = std::clamp(1.0f - cosine, 0.0f, 1.0f);
    const float rest2 = rest * rest;
    return f0 + (V3f(1.0f) - f0) * (rest2 * rest2 * rest);
}

}  // namespace carom::render
