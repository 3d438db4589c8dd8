// Half floats of finite values (IEEE 754 binary16): of two that are equally near, the even one, and
// of values beyond the largest one, that one. Without branches, so that compilers use vectors.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include <Imath/half.h>

namespace carom::render {

namespace half_float {

inline constexpr float kLargest = 65504;
inline constexpr float kLeastNormal = 1.0F / (1 << 14);
inline constexpr std::uint32_t kDroppedDigits = 13;  // of a float's

/// Rounds away the digits that a normal half float lacks.
[[nodiscard]] inline std::uint32_t rounded(std::uint32_t bits) {
    const std::uint32_t odd = bits >> kDroppedDigits & 1U;
    return (bits + (1U << (kDroppedDigits - 1)) - 1 + odd) >> kDroppedDigits;
}

/// A float of this size has the last digit of half floats below the least normal one.
inline constexpr float kRounding = 0.5F;

}  // namespace half_float

/// The half float as a float.
[[nodiscard]] inline float as_half(float value) {
    using namespace half_float;
    const float limited = std::clamp(value, -kLargest, kLargest);
    const float size = std::abs(limited);
    const auto normal =
        std::bit_cast<float>(rounded(std::bit_cast<std::uint32_t>(limited)) << kDroppedDigits);
    const float small = std::copysign((size + kRounding) - kRounding, limited);
    return size < kLeastNormal ? small : normal;
}

/// Its bits.
[[nodiscard]] inline std::uint16_t half_bits(float value) {
    using namespace half_float;
    constexpr std::uint32_t kExponentOffset = 127 - 15;
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const auto size = static_cast<std::uint32_t>(
        std::min(static_cast<std::int32_t>(bits & 0x7fff'ffffU),
                 static_cast<std::int32_t>(std::bit_cast<std::uint32_t>(kLargest))));
    const std::uint32_t normal = rounded(size) - (kExponentOffset << 10);
    const std::uint32_t small =
        std::bit_cast<std::uint32_t>(std::bit_cast<float>(size) + kRounding) -
        std::bit_cast<std::uint32_t>(kRounding);
    const bool is_small = size < std::bit_cast<std::uint32_t>(kLeastNormal);
    return static_cast<std::uint16_t>((bits >> 16 & 0x8000U) | (is_small ? small : normal));
}

[[nodiscard]] inline Imath::half to_half(float value) {
    Imath::half result;
    result.setBits(half_bits(value));
    return result;
}

}  // namespace carom::render
