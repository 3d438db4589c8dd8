// The threshold pattern of dithering, which hides the quantisation steps of 8-bit pictures.
#pragma once

#include <cstdint>

namespace carom::pipeline {

/// A threshold in [0, 65536) for each pixel. It depends only on the pixel's coordinates: every
/// frame has the same pattern, so that a static picture stays static and costs an encoder almost
/// nothing.
///
/// The additive recurrence with the powers of the plastic number 1.3247..., the root of
/// x^3 = x + 1: t(x, y) = frac(x / p + y / p^2) (M. Roberts, "The Unreasonable Effectiveness of
/// Quasirandom Sequences", 2018, section on dithering). The thresholds in any small window are
/// spread evenly over [0, 1), and the pattern has little energy at low frequencies, where the eye
/// would see it. In 32-bit fixed point the fraction is exact.
[[nodiscard]] constexpr std::uint32_t dither_threshold(std::uint32_t x, std::uint32_t y) {
    constexpr std::uint32_t kInversePlastic = 3242174889U;         // 2^32 / p
    constexpr std::uint32_t kInversePlasticSquared = 2447445414U;  // 2^32 / p^2
    return (x * kInversePlastic + y * kInversePlasticSquared) >> 16U;
}

}  // namespace carom::pipeline
