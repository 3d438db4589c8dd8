// Numbers with units: "57.15 mm", "1/48 s", "20 km/h".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace carom::pipeline::config {

/// What a value measures; decides which units it may carry. A plain number is in the SI unit.
enum class Dimension {
    none,
    length,
    mass,
    time,
    angle,
    speed,
    angular_speed,
    acceleration,
    density,
    force,
    torque,
    impulse,
    frequency,
};

/// Powers of metre, kilogram, second and radian.
struct Exponents {
    int metre = 0;
    int kilogram = 0;
    int second = 0;
    int radian = 0;

    bool operator==(const Exponents&) const = default;
};

/// numerator / denominator, denominator > 0, in lowest terms.
struct Fraction {
    std::int64_t numerator = 0;
    std::int64_t denominator = 1;
};

/// A number as it was written.
struct Quantity {
    double value = 0;  // in SI units
    bool has_unit = false;
    Exponents exponents;            // of its unit
    std::optional<Fraction> exact;  // the value in SI units, in degrees for an angle given in them
    bool is_in_degrees = false;
};

/// What a dimension is called and how its values are shown.
struct DimensionInfo {
    Dimension dimension = Dimension::none;
    Exponents exponents;
    std::string name;       // "a length"
    std::string plural;     // "lengths"
    std::string units;      // "m, cm, mm, in, ft": for messages and the reference
    std::string unit;       // in which ranges and defaults are shown: "m", "deg"
    double unit_value = 1;  // of that unit in SI units
};

[[nodiscard]] const DimensionInfo& info(Dimension dimension);

/// The units of exactly these exponents that have a name of their own: "m", "km" ...; all units
/// without an argument.
[[nodiscard]] std::vector<std::string> unit_names(const std::optional<Exponents>& of = {});

/// "a length", or "kg m/s" where the exponents have no name.
[[nodiscard]] std::string name_of(const Exponents& exponents);

/// "9.81 m/s^2", "30 deg": the shortest decimal that reads back as the same number of the shown
/// unit.
[[nodiscard]] std::string show(double value, Dimension dimension);

/// The shortest decimal that reads back as the same number.
[[nodiscard]] std::string show(double value);

/// Reads a number, a fraction of two numbers, and a unit behind it. Independent of the locale; NaN,
/// infinities, hexadecimal and numbers too large for a double are refused. The string is what is
/// wrong, to follow "'duration' ...": "is not a number" ...
[[nodiscard]] std::variant<Quantity, std::string> parse_quantity(std::string_view text);

/// Whether the text starts like a number (so that a word can be told from a misspelt quantity).
[[nodiscard]] bool looks_like_number(std::string_view text);

}  // namespace carom::pipeline::config
