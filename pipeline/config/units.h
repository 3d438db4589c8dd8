// Units and what they measure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/config/fraction.h"

namespace carom::pipeline::config {

/// What a value measures; decides which units it may carry. A plain number is in the SI unit, where
/// plain numbers are taken.
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

/// A unit that has a name of its own.
struct Unit {
    std::string_view name;
    Exponents exponents;
    double value = 1;      // in SI units
    Fraction exact{0, 1};  // the same (for degrees: in degrees); numerator 0 where there is none
    bool is_degree = false;
};

/// The unit of that name, or nullptr.
[[nodiscard]] const Unit* find_unit(std::string_view name);

/// The units of exactly these exponents that have a name of their own: "m", "km" ...; all units
/// without an argument.
[[nodiscard]] std::vector<std::string> unit_names(const std::optional<Exponents>& of = {});

/// What a dimension is called and how its values are shown.
struct DimensionInfo {
    Dimension dimension = Dimension::none;
    Exponents exponents;
    std::string name;       // "a length"
    std::string plural;     // "lengths"
    std::string units;      // "m, cm, mm, in, ft": for messages and the reference
    std::string unit;       // in which ranges and defaults are shown: "m", "deg"
    double unit_value = 1;  // of that unit in SI units
    /// Whether a plain number (other than 0) is refused, because some readers would take it to be
    /// in `unit` and others in the SI unit or in another common one.
    bool needs_unit = false;
};

[[nodiscard]] const DimensionInfo& info(Dimension dimension);

/// "a length"; "a quantity of another kind" where the exponents have no name.
[[nodiscard]] std::string name_of(const Exponents& exponents);

}  // namespace carom::pipeline::config
