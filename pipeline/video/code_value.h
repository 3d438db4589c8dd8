// Rounding of a signal to 16-bit code values.
#pragma once

#include <cstdint>

namespace carom::pipeline {

/// The code nearest to a value in [0, 65535]; halves are rounded up. This runs for each channel of
/// each pixel: truncation is one instruction, std::lround is a function call.
inline std::uint16_t nearest_code(float value) {
    return static_cast<std::uint16_t>(value + 0.5F);  // NOLINT(bugprone-incorrect-roundings)
}

}  // namespace carom::pipeline
