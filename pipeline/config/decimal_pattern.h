// Regular expressions that match the decimal numbers of a range.
#pragma once

#include <string>

#include "pipeline/config/type_info.h"

namespace carom::pipeline::config {

/// Matches the decimal numbers ("5", "-0.5", "12.", ".5", without an exponent) within `range`.
/// Limits with more than nine digits are rounded outwards to nine.
[[nodiscard]] std::string decimal_pattern(const Range& range);

/// Matches the optional sign of any number in `range` (and of zero).
[[nodiscard]] std::string sign_pattern(const Range& range);

}  // namespace carom::pipeline::config
