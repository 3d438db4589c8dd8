// Parses the numbers with units that options take.
#pragma once

#include <string>
#include <string_view>

#include "pipeline/camera/rational.h"
#include "pipeline/config/units.h"

namespace carom::cli {

/// The exact value of an option in SI units: a plain number, or one with a unit of the dimension
/// `exponents`. Throws an InputError that says what was `expected`: "a time; write 1.25s".
[[nodiscard]] pipeline::Rational parse_value(std::string_view text,
                                             const pipeline::config::Exponents& exponents,
                                             const std::string& expected);

}  // namespace carom::cli
