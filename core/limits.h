// Limits for the input.
#pragma once

#include <cstddef>
#include <string>

namespace carom {

/// `usual` times $CAROM_LIMITS, a number in [1, 1000]; if it is not set or invalid, 1.
[[nodiscard]] std::size_t input_limit(std::size_t usual);

/// "more than 250000 WHAT; CAROM_LIMITS=2 in the environment doubles all such limits".
[[nodiscard]] std::string beyond_limit(std::size_t limit, const std::string& what);

/// The second half of that sentence.
[[nodiscard]] const char* how_to_raise_limits();

}  // namespace carom
