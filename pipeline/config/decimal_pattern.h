// Regular expressions for decimal numbers within a range.
#pragma once

#include <string>

#include "pipeline/config/type_info.h"

namespace carom::pipeline::config {

/// Matches the decimal numbers ("5", "-0.5", "12.", ".5", without an exponent) within `range`. Ends
/// of more than nine digits are rounded outwards to nine.
[[nodiscard]] std::string decimal_pattern(const Range& range);

/// Matches the sign or none in front of any number of `range` (and of zero).
[[nodiscard]] std::string sign_pattern(const Range& range);

}  // namespace carom::pipeline::config
