// Fresnel reflectance.
#pragma once

#include "render/geometry/ray.h"
#include "render/material/scalar_kernels.h"

namespace carom::render {

// The formulas and their sources are in kernels/fresnel.h.

/// Unpolarised reflectance of a boundary between dielectrics from outside. `cosine`: of the angle
/// of incidence, [0, 1]; `ior`: relative index, >= 1. Returns a value in [0, 1].
[[nodiscard]] inline float fresnel_dielectric(float cosine, float ior) {
    return scalar::fresnel_dielectric<scalar::One>(cosine, ior);
}

/// Reflectance of a metal with the reflectance `f0` at normal incidence.
[[nodiscard]] inline V3f fresnel_schlick(float cosine, const V3f& f0) {
    return scalar::vector_of(scalar::fresnel_schlick<scalar::One>(cosine, scalar::three(f0)));
}

}  // namespace carom::render
