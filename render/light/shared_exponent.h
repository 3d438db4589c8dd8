// A colour in 32 bits: three non-negative numbers of nine bits with a shared exponent.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "render/geometry/ray.h"
#include "render/light/scalar_kernels.h"

namespace carom::render {

/// The layout of the OpenGL extension EXT_texture_shared_exponent: value = m 2^(e - 24), m < 512, e
/// < 32. The largest channel is accurate to 1 part in 512, the others to the same absolute error. A
/// picture takes a third of the memory of floats, and memory is the cost of random access to it.
class SharedExponent {
  public:
    static constexpr float kLargest = 511.0f * 128.0f;  // 511 2^(31 - 24)

    SharedExponent() = default;

    /// Channels are finite and >= 0; those above kLargest become kLargest.
    explicit SharedExponent(const V3f& c) {
        const float r = std::min(c.x, kLargest);
        const float g = std::min(c.y, kLargest);
        const float b = std::min(c.z, kLargest);
        const float largest = std::max({r, g, b});
        if (largest <= 0) {
            return;
        }
        // The smallest exponent for which the rounded mantissa of the largest channel stays below
        // 512.
        int exponent = std::max(0, std::ilogb(largest) + 24 - 8);
        if (std::lrint(std::ldexp(largest, 24 - exponent)) > 511) {
            exponent += 1;
        }
        const auto mantissa = [&](float x) {
            return static_cast<std::uint32_t>(std::lrint(std::ldexp(x, 24 - exponent)));
        };
        bits_ = mantissa(r) | mantissa(g) << 9 | mantissa(b) << 18 |
                static_cast<std::uint32_t>(exponent) << 27;
    }

    [[nodiscard]] static SharedExponent of_bits(std::uint32_t bits) {
        SharedExponent colour;
        colour.bits_ = bits;
        return colour;
    }
    [[nodiscard]] V3f value() const { return scalar::shared_exponent_value<scalar::One>(bits_); }
    [[nodiscard]] std::uint32_t bits() const { return bits_; }

  private:
    std::uint32_t bits_ = 0;
};

}  // namespace carom::render
