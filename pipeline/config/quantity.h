// Parses numbers with units: "57.15 mm", "1/48 s", "20 km/h".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "pipeline/config/message.h"
#include "pipeline/config/units.h"

namespace carom::pipeline::config {

/// A number with the unit in which it was written.
struct Quantity {
    double value = 0;  // in SI units
    bool has_unit = false;
    Exponents exponents;            // of its unit
    std::optional<Fraction> exact;  // the value in SI units, or in degrees if `is_in_degrees`
    bool is_in_degrees = false;
};

/// The problem of the text of a number.
struct QuantityProblem {
    enum class Kind { not_a_number, unknown_unit, other };
    Kind kind = Kind::other;
    Message message;  // without its subject: "has the unknown unit ..."
};

/// Parses a number or a fraction of two numbers, with an optional unit after it. The result does
/// not depend on the locale. NaN, infinities, hexadecimal numbers and numbers too large for a
/// double are refused.
[[nodiscard]] std::variant<Quantity, QuantityProblem> parse_quantity(std::string_view text);

/// Whether the text starts with a number, so that it is a misspelt quantity and not a word.
[[nodiscard]] bool looks_like_number(std::string_view text);

}  // namespace carom::pipeline::config
