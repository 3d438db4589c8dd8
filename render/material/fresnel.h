// Fresnel reflectance.
#pragma once

#include <algorithm>
#include <cmath>

#include "render/geometry/ray.h"

namespace carom::render {

/// Unpolarised reflectance of a boundary between dielectrics from outside (Born and Wolf,
/// "Principles of Optics", 7th ed. 1999, section 1.5.2: the mean of the squares of eq. 21 a and b).
/// `cosine`: of the angle of incidence, [0, 1]; `ior`: relative index, >= 1. Returns a value in [0,
/// 1].
[[nodiscard]] inline float fresnel_dielectric(float cosine, float ior) {
    const float cos_i = std::min(cosine, 1.0f);
    const float sin2_t = (1.0f - cos_i * cos_i) / (ior * ior);
    const float cos_t = std::sqrt(std::max(0.0f, 1.0f - sin2_t));
    const float parallel = (ior * cos_i - cos_t) / (ior * cos_i + cos_t);
    const float perpendicular = (cos_i - ior * cos_t) / (cos_i + ior * cos_t);
    return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}

/// Reflectance of a metal with the reflectance `f0` at normal incidence (Schlick 1994, "An
/// inexpensive BRDF model for physically-based rendering", eq. 15).
[[nodiscard]] inline V3f fresnel_schlick(float cosine, const V3f& f0) {
    const float rest = std::clamp(1.0f - cosine, 0.0f, 1.0f);
    const float rest2 = rest * rest;
    return f0 + (V3f(1.0f) - f0) * (rest2 * rest2 * rest);
}

}  // namespace carom::render
