// Random numbers that do not depend on compiler and library: SplitMix64 (Steele, Lea and Flood
// 2014, "Fast splittable pseudorandom number generators", OOPSLA, figures 16 and 17).
#pragma once

#include <cstdint>

namespace carom {

/// The increment of the state of SplitMix64 from one number to the next: 2^64 / golden ratio.
inline constexpr std::uint64_t kSplitMixStep = 0x9E3779B97F4A7C15U;

/// The output function of SplitMix64: each bit of the result depends on every bit of the state.
[[nodiscard]] constexpr std::uint64_t split_mix(std::uint64_t state) {
    state = (state ^ (state >> 30U)) * 0xBF58476D1CE4E5B9U;
    state = (state ^ (state >> 27U)) * 0x94D049BB133111EBU;
    return state ^ (state >> 31U);
}

/// The upper 53 bits as a number in [0, 1).
[[nodiscard]] constexpr double unit_number(std::uint64_t bits) {
    return static_cast<double>(bits >> 11U) * 0x1p-53;
}

class SplitMix64 {
  public:
    explicit constexpr SplitMix64(std::uint64_t seed) : state_(seed) {}

    constexpr std::uint64_t next() { return split_mix(state_ += kSplitMixStep); }
    /// A number in [0, 1).
    constexpr double next_unit() { return unit_number(next()); }
    constexpr double between(double low, double high) { return low + (high - low) * next_unit(); }

  private:
    std::uint64_t state_;
};

}  // namespace carom
