// Gaussian lobes: directions whose angle from an axis is normally distributed (gloss and
// translucency of Cook, Porter and Carpenter 1984, "Distributed ray tracing").
#pragma once

#include "render/geometry/ray.h"

namespace carom::render {

/// Inverse of the error function for y in (-1, 1), to about 3e-7 of its value
/// (kernels/gaussian_lobe.h).
[[nodiscard]] float inverse_erf(float y);

/// The probability that |x| <= pi / 2 for a normally distributed x of standard deviation `spread`.
[[nodiscard]] float gaussian_within_a_quarter_turn(float spread);

/// Unit direction about +z for `u` in [0, 1)^2: the angle from the axis is |x| for a normally
/// distributed x of standard deviation `spread` (rad, > 0), cut off at pi / 2; the azimuth is
/// uniform.
[[nodiscard]] V3f sample_gaussian_lobe(const V2f& u, float spread);

/// Density of the angle of `sample_gaussian_lobe`, 1/rad, for an angle in [0, pi / 2].
[[nodiscard]] double pdf_gaussian_lobe_angle(double angle, double spread);

}  // namespace carom::render
