// Maps from the unit square to the domains that a renderer samples, each with its density.
//
// Every `sample_X` takes numbers in [0, 1) and returns a point distributed as `pdf_X` says; the
// density is per unit of the measure named at each pair and integrates to one over the domain. A
// density of zero means that the sampler cannot return the point.
#pragma once

#include <algorithm>
#include <cmath>

#include "render/geometry/ray.h"
#include "render/geometry/trigonometry.h"
#include "render/sampling/one_minus_epsilon.h"
#include "render/sampling/scalar_kernels.h"

namespace carom::render {

// ---- unit disk, per area ---------------------------------------------------------------------

/// Concentric map (Shirley and Chiu 1997, "A low distortion map between disk and square").
[[nodiscard]] inline V2f sample_disk(const V2f& u) {
    return scalar::vector_of(scalar::sample_disk<scalar::One>(scalar::two(u)));
}

[[nodiscard]] inline float pdf_disk(const V2f& p) {
    return p.length2() <= 1 ? kInversePi : 0;
}

// ---- regular polygon inscribed in the unit circle, per area ----------------------------------

/// The polygon has corners at the angles rotation + 2 pi k / blades; blades >= 3.
[[nodiscard]] inline V2f sample_polygon(const V2f& u, int blades, float rotation_turns) {
    return scalar::vector_of(
        scalar::sample_polygon<scalar::One>(scalar::two(u), blades, rotation_turns));
}

/// Inside the polygon; the caller handles points outside, where the density is zero.
[[nodiscard]] inline float pdf_polygon(int blades) {
    const float n = static_cast<float>(blades);
    return 2 / (n * sin_cos_turn(1 / n).sine);
}

// ---- hemisphere about +z, per solid angle ----------------------------------------------------

/// Density cos(theta) / pi (Malley's method over the concentric disk).
[[nodiscard]] inline V3f sample_cosine_hemisphere(const V2f& u) {
    return scalar::vector_of(scalar::sample_cosine_hemisphere<scalar::One>(scalar::two(u)));
}

[[nodiscard]] inline float pdf_cosine_hemisphere(float cos_theta) {
    return std::max(0.f, cos_theta) * kInversePi;
}

// ---- cone about +z, per solid angle ----------------------------------------------------------

/// 1 - cos(theta_max) of the cone that a sphere of `radius` subtends at `distance` > radius from
/// its centre. It stays accurate for a distant sphere, where the cosine is almost 1.
[[nodiscard]] inline float one_minus_cos_of_sphere(float radius, float distance) {
    return scalar::one_minus_cos_of_sphere<scalar::One>(radius, distance);
}

/// Uniform within the cone 1 - cos(theta) <= one_minus_cos, one_minus_cos in (0, 2].
[[nodiscard]] inline V3f sample_cone(const V2f& u, float one_minus_cos) {
    return scalar::vector_of(scalar::sample_cone<scalar::One>(scalar::two(u), one_minus_cos));
}

/// Inside the cone; the caller handles directions outside, where the density is zero.
[[nodiscard]] inline float pdf_cone(float one_minus_cos) {
    return 1 / (2 * kPi * one_minus_cos);
}

// ---- whole sphere, per solid angle -----------------------------------------------------------

[[nodiscard]] inline V3f sample_sphere(const V2f& u) {
    return sample_cone(u, 2);
}
[[nodiscard]] inline float pdf_sphere() {
    return 0.25f * kInversePi;
}

// ---- triangle, per area ----------------------------------------------------------------------

/// Barycentric weights of the second and third corner; density 1 / area.
[[nodiscard]] inline V2f sample_triangle(const V2f& u) {
    const float r = std::sqrt(u.x);
    return V2f(r * (1 - u.y), r * u.y);
}

// ---- trapezoid over [0, 1], per length -------------------------------------------------------

/// Opening times of a shutter that opens linearly during the first switch_ratio / 2 and closes
/// linearly during the last switch_ratio / 2: the inverse of the cumulative distribution.
/// switch_ratio in [0, 1]; 0 returns `u` itself.
[[nodiscard]] inline float sample_trapezoid(float u, float switch_ratio) {
    return scalar::sample_trapezoid<scalar::One>(u, switch_ratio);
}

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
