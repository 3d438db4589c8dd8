// Signal to 16-bit code values.
#pragma once

#include <cstdint>

namespace carom::pipeline {

/// The nearest code to a value in [0, 65535], halves upwards. For each channel of each pixel:
/// cutting off is one instruction, where std::lround is a call.
inline std::uint16_t nearest_code(float value) {
    return static_cast<std::uint16_t>(value + 0.5F);  // NOLINT(bugprone-incorrect-roundings)
}

}  // namespace carom::pipeline
