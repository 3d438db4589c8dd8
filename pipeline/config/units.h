// Units and physical dimensions.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/config/fraction.h"

namespace carom::pipeline::config {

/// The physical dimension of a value, which determines its units. A plain number is in the SI unit,
/// if the dimension allows plain numbers.
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
    pressure,
    level,     // a gain in decibels
    loudness,  // of a film, in LUFS
};

/// Powers of metre, kilogram, second and radian. Decibels and LUFS are logarithms of ratios. They
/// are kinds of their own, because no other unit can be converted to them.
struct Exponents {
    int metre = 0;
    int kilogram = 0;
    int second = 0;
    int radian = 0;
    int decibel = 0;
    int lufs = 0;

    bool operator==(const Exponents&) const = default;
};

/// A named unit.
struct Unit {
    std::string_view name;
    Exponents exponents;
    double value = 1;      // in SI units
    Fraction exact{0, 1};  // exact value (of degrees: in degrees); numerator 0 if there is none
    bool is_degree = false;
};

/// The unit of that name, or nullptr.
[[nodiscard]] const Unit* find_unit(std::string_view name);

/// The names of the units with exactly these exponents: "m", "km" ...; without an argument, of all
/// units.
[[nodiscard]] std::vector<std::string> unit_names(const std::optional<Exponents>& of = {});

/// The name of a dimension and the format of its values.
struct DimensionInfo {
    Dimension dimension = Dimension::none;
    Exponents exponents;
    std::string name;       // "a length"
    std::string plural;     // "lengths"
    std::string units;      // "m, cm, mm, in, ft": for messages and the reference
    std::string unit;       // unit of displayed ranges and defaults: "m", "deg"
    double unit_value = 1;  // of that unit in SI units
    /// Whether a plain number (other than 0) is refused, because some readers would assume `unit`
    /// and others the SI unit or another common one.
    bool needs_unit = false;
    /// Whether the values are logarithms. 0 dB is a factor of 1, so 0 needs its unit as well.
    bool is_logarithmic = false;
};

[[nodiscard]] const DimensionInfo& info(Dimension dimension);

/// "a length"; "a quantity of another kind" if the exponents have no name.
[[nodiscard]] std::string name_of(const Exponents& exponents);

}  // namespace carom::pipeline::config
