// What a film must be before it is written.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <string>

#include "render/film/film.h"

namespace carom::render {

/// Whether numbers are finite, without a branch for each.
class FiniteCheck {
  public:
    void add(float value) {
        largest_ =
            std::max(largest_,
                     static_cast<std::int32_t>(std::bit_cast<std::uint32_t>(value) & 0x7fff'ffffU));
    }
    /// The exponent of what is not finite has all bits set (IEEE 754).
    [[nodiscard]] bool all_finite() const { return largest_ < 0x7f80'0000; }

  private:
    std::int32_t largest_ = 0;  // bits without the sign
};

[[nodiscard]] bool all_finite(std::span<const float> values);

/// Asserts that all channels have the film's size. Throws Error with the path if a value is
/// infinite or not a number.
void check_film(const Film& film, const std::string& path);

}  // namespace carom::render
