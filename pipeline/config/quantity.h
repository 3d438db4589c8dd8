// Numbers with units as they are written: "57.15 mm", "1/48 s", "20 km/h".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "pipeline/config/units.h"

namespace carom::pipeline::config {

/// A number as it was written.
struct Quantity {
    double value = 0;  // in SI units
    bool has_unit = false;
    Exponents exponents;            // of its unit
    std::optional<Fraction> exact;  // the value in SI units, in degrees for an angle given in them
    bool is_in_degrees = false;
};

/// Reads a number, a fraction of two numbers, and a unit behind it. Independent of the locale; NaN,
/// infinities, hexadecimal and numbers too large for a double are refused. The string is what is
/// wrong, to follow "'duration' ...": "is not a number" ...
[[nodiscard]] std::variant<Quantity, std::string> parse_quantity(std::string_view text);

/// Whether the text starts like a number (so that a word can be told from a misspelt quantity).
[[nodiscard]] bool looks_like_number(std::string_view text);

}  // namespace carom::pipeline::config
