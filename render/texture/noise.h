// Reproducible noise in the plane and in space from an integer hash, with the same bits on every
// machine.
#pragma once

#include <cstdint>

#include "render/geometry/ray.h"

namespace carom::render {

/// A well-mixed permutation of 32-bit integers (kernels/noise.h).
[[nodiscard]] std::uint32_t mix_bits(std::uint32_t x);

[[nodiscard]] float unit_float(std::uint32_t bits);  // [0, 1)

/// Gradient noise after Perlin, "Improving Noise", 2002 (quintic fade, eq. 1; gradients towards the
/// edges of a cube), on a lattice that is hashed instead of tabulated. Mean 0, range within [-1,
/// 1], one feature per unit length. Coordinates beyond +-2^30 repeat.
[[nodiscard]] float gradient_noise(const V3f& position, std::uint32_t seed);
[[nodiscard]] float gradient_noise(const V2f& position, std::uint32_t seed);

/// The same noise, repeating every `period_x`, `period_y` > 0 units without a seam.
[[nodiscard]] float periodic_noise(const V2f& position, int period_x, int period_y,
                                   std::uint32_t seed);

/// The gradient at a corner of the plane's lattice: one of eight directions.
[[nodiscard]] V2f lattice_gradient(std::uint32_t column, std::uint32_t row, std::uint32_t seed);

/// Perlin's weight of a cell's far corner, for an offset in [0, 1].
[[nodiscard]] float noise_fade(float t);

/// Sum of `octaves` gradient noises, each of twice the frequency and half the amplitude of the
/// previous one; the first has amplitude 1. Octaves finer than `footprint` (in units of `position`)
/// fade out, so that the sum is band-limited to what a pixel can show.
[[nodiscard]] float fractal_noise(const V3f& position, int octaves, float footprint,
                                  std::uint32_t seed);
[[nodiscard]] float fractal_noise(const V2f& position, int octaves, float footprint,
                                  std::uint32_t seed);

/// Weight of a pattern of the given period after averaging over `footprint` (same unit): 1 while
/// the period is well resolved, 0 from two periods per three footprints on.
[[nodiscard]] float band_weight(float footprint, float period);

/// The fraction of [x - width/2, x + width/2] above 0, smoothed: an anti-aliased step.
[[nodiscard]] float smooth_step(float x, float width);

}  // namespace carom::render
