#include "pipeline/config/units.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "pipeline/config/fraction.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// A unit's value in SI units; `exact` is that value as a fraction (for degrees: one degree),
/// numerator 0 where there is none.
struct Unit {
    std::string_view name;
    Exponents exponents;
    double value = 1;
    Fraction exact{0, 1};
    bool is_degree = false;
};

constexpr Exponents kLength{1, 0, 0, 0};
constexpr Exponents kMass{0, 1, 0, 0};
constexpr Exponents kTime{0, 0, 1, 0};
constexpr Exponents kAngle{0, 0, 0, 1};
constexpr Exponents kForce{1, 1, -2, 0};
constexpr Exponents kSpeed{1, 0, -1, 0};
constexpr Exponents kFrequency{0, 0, -1, 0};

// International yard and pound agreement, 1959: 1 yd = 0.9144 m, 1 lb = 0.45359237 kg.
constexpr std::array kUnits{
    Unit{"m", kLength, 1, {1, 1}},
    Unit{"km", kLength, 1000, {1000, 1}},
    Unit{"cm", kLength, 0.01, {1, 100}},
    Unit{"mm", kLength, 0.001, {1, 1000}},
    Unit{"um", kLength, 1e-6, {1, 1000000}},
    Unit{"in", kLength, 0.0254, {127, 5000}},
    Unit{"ft", kLength, 0.3048, {381, 1250}},
    Unit{"yd", kLength, 0.9144, {1143, 1250}},
    Unit{"kg", kMass, 1, {1, 1}},
    Unit{"g", kMass, 0.001, {1, 1000}},
    Unit{"mg", kMass, 1e-6, {1, 1000000}},
    Unit{"lb", kMass, 0.45359237, {45359237, 100000000}},
    Unit{"oz", kMass, 0.028349523125, {45359237, 1600000000}},
    Unit{"s", kTime, 1, {1, 1}},
    Unit{"ms", kTime, 0.001, {1, 1000}},
    Unit{"us", kTime, 1e-6, {1, 1000000}},
    Unit{"min", kTime, 60, {60, 1}},
    Unit{"h", kTime, 3600, {3600, 1}},
    Unit{"rad", kAngle, 1},
    Unit{"deg", kAngle, kPi / 180, {1, 1}, true},
    Unit{"turn", kAngle, 2 * kPi, {360, 1}, true},
    Unit{"rpm", {0, 0, -1, 1}, 2 * kPi / 60},
    Unit{"mph", kSpeed, 0.44704, {1397, 3125}},
    Unit{"N", kForce, 1, {1, 1}},
    Unit{"mN", kForce, 0.001, {1, 1000}},
    Unit{"kN", kForce, 1000, {1000, 1}},
    Unit{"Hz", kFrequency, 1, {1, 1}},
    Unit{"kHz", kFrequency, 1000, {1000, 1}},
    Unit{"fps", kFrequency, 1, {1, 1}},
};

const std::array kDimensions{
    DimensionInfo{Dimension::none, {}, "a plain number", "plain numbers", "", "", 1},
    DimensionInfo{Dimension::length, kLength, "a length", "lengths", "m, cm, mm, in, ft", "m", 1},
    DimensionInfo{Dimension::mass, kMass, "a mass", "masses", "kg, g, oz, lb", "kg", 1},
    DimensionInfo{Dimension::time, kTime, "a time", "times", "s, ms, min", "s", 1},
    DimensionInfo{Dimension::angle, kAngle, "an angle", "angles", "rad, deg, turn", "deg",
                  kPi / 180},
    DimensionInfo{Dimension::speed, kSpeed, "a speed", "speeds", "m/s, km/h, mph", "m/s", 1},
    DimensionInfo{Dimension::angular_speed,
                  {0, 0, -1, 1},
                  "an angular velocity",
                  "angular velocities",
                  "rad/s, deg/s, rpm",
                  "rad/s",
                  1},
    DimensionInfo{Dimension::acceleration,
                  {1, 0, -2, 0},
                  "an acceleration",
                  "accelerations",
                  "m/s^2",
                  "m/s^2",
                  1},
    DimensionInfo{
        Dimension::density, {-3, 1, 0, 0}, "a density", "densities", "kg/m^3, g/cm^3", "kg/m^3", 1},
    DimensionInfo{Dimension::force, kForce, "a force", "forces", "N, mN", "N", 1},
    DimensionInfo{Dimension::torque, {2, 1, -2, 0}, "a torque", "torques", "N m", "N m", 1},
    DimensionInfo{Dimension::impulse, {1, 1, -1, 0}, "an impulse", "impulses", "N s", "N s", 1},
    DimensionInfo{Dimension::frequency, kFrequency, "a frequency", "frequencies", "Hz, fps", "Hz",
                  1},
};

constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

constexpr bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

void skip_blanks(std::string_view& text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) {
        text.remove_prefix(1);
    }
}

const Unit* find_unit(std::string_view name) {
    for (const Unit& unit : kUnits) {
        if (unit.name == name) {
            return &unit;
        }
    }
    return nullptr;
}

std::string unknown_unit(std::string_view name) {
    std::vector<std::string> known;
    for (const Unit& unit : kUnits) {
        known.emplace_back(unit.name);
    }
    return "has the unknown unit " + quote(name) + hint(name, known);
}

/// Length of the decimal number that `text` starts with; 0 if it does not.
std::size_t number_length(std::string_view text) {
    std::size_t i = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
    const std::size_t first_digit = i;
    std::size_t digits = 0;
    for (; i < text.size() && is_digit(text[i]); ++i) {
        ++digits;
    }
    if (i < text.size() && text[i] == '.') {
        ++i;
        for (; i < text.size() && is_digit(text[i]); ++i) {
            ++digits;
        }
    }
    if (digits == 0 || i == first_digit) {
        return 0;
    }
    if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
        std::size_t j = i + 1;
        j += j < text.size() && (text[j] == '+' || text[j] == '-') ? 1 : 0;
        if (j < text.size() && is_digit(text[j])) {
            while (j < text.size() && is_digit(text[j])) {
                ++j;
            }
            i = j;
        }
    }
    return i;
}

struct Number {
    double value = 0;
    std::optional<Fraction> exact;
};

/// Takes a number off the front of `text`; empty if it is too large for a double.
std::optional<Number> take_number(std::string_view& text, std::size_t length) {
    std::string_view digits = text.substr(0, length);
    text.remove_prefix(length);
    if (digits.front() == '+') {
        digits.remove_prefix(1);
    }
    Number number;
    const auto [end, code] =
        std::from_chars(digits.data(), digits.data() + digits.size(), number.value);
    if (code == std::errc::result_out_of_range) {
        // Both overflow and underflow end here; what is too small to write is zero to us.
        const std::size_t exponent = digits.find_first_of("eE");
        if (exponent == std::string_view::npos || digits[exponent + 1] != '-') {
            return std::nullopt;
        }
        number.value = 0;
    }
    number.exact = decimal_fraction(digits);
    return number;
}

/// Multiplies `quantity` by a unit to the power of `exponent`.
void apply(Quantity& quantity, const Unit& unit, int exponent) {
    quantity.exponents.metre += exponent * unit.exponents.metre;
    quantity.exponents.kilogram += exponent * unit.exponents.kilogram;
    quantity.exponents.second += exponent * unit.exponents.second;
    quantity.exponents.radian += exponent * unit.exponents.radian;
    for (int i = 0; i < std::abs(exponent); ++i) {
        quantity.value = exponent > 0 ? quantity.value * unit.value : quantity.value / unit.value;
        if (quantity.exact && unit.exact.numerator != 0) {
            quantity.exact = exponent > 0 ? multiply(*quantity.exact, unit.exact)
                                          : divide(*quantity.exact, unit.exact);
        } else {
            quantity.exact.reset();
        }
    }
}

/// The power behind a unit's name: "^2", "2", "^-1" or nothing.
int take_power(std::string_view& text) {
    std::size_t i = !text.empty() && text[0] == '^' ? 1 : 0;
    const bool negative = i < text.size() && i == 1 && text[i] == '-';
    i += negative ? 1 : 0;
    if (i >= text.size() || text[i] < '1' || text[i] > '9') {
        return 1;
    }
    const int power = text[i] - '0';
    text.remove_prefix(i + 1);
    return negative ? -power : power;
}

/// Reads "km/h" or "N m" and applies it; the string is what is wrong, empty if nothing.
std::string apply_units(Quantity& quantity, std::string_view text) {
    const std::string_view whole = text;
    int sign = 1;
    int unit_count = 0;
    bool needs_unit = false;
    const Unit* last = nullptr;
    while (!text.empty()) {
        const char c = text.front();
        if (c == ' ' || c == '\t') {
            text.remove_prefix(1);
        } else if ((c == '/' || c == '*') && unit_count > 0 && !needs_unit) {
            sign = c == '/' ? -1 : 1;
            needs_unit = true;
            text.remove_prefix(1);
        } else if (is_letter(c)) {
            std::size_t length = 0;
            while (length < text.size() && is_letter(text[length])) {
                ++length;
            }
            last = find_unit(text.substr(0, length));
            if (last == nullptr) {
                return unknown_unit(text.substr(0, length));
            }
            text.remove_prefix(length);
            apply(quantity, *last, sign * take_power(text));
            ++unit_count;
            needs_unit = false;
            sign = 1;
        } else {
            return unknown_unit(whole);
        }
    }
    if (needs_unit || unit_count == 0) {
        return unknown_unit(whole);
    }
    quantity.has_unit = true;
    quantity.is_in_degrees = unit_count == 1 && last->is_degree;
    return {};
}

bool is_angular(const Exponents& e) {
    return e.radian != 0;
}

}  // namespace

const DimensionInfo& info(Dimension dimension) {
    return kDimensions.at(static_cast<std::size_t>(dimension));
}

std::vector<std::string> unit_names(const std::optional<Exponents>& of) {
    std::vector<std::string> names;
    for (const Unit& unit : kUnits) {
        if (!of || unit.exponents == *of) {
            names.emplace_back(unit.name);
        }
    }
    return names;
}

std::string name_of(const Exponents& exponents) {
    for (const DimensionInfo& known : kDimensions) {
        if (known.exponents == exponents) {
            return known.name;
        }
    }
    return "a quantity of another kind";
}

std::string show(double value) {
    const double size = std::abs(value);
    const auto form = value == 0 || (size >= 1e-4 && size < 1e16) ? std::chars_format::fixed
                                                                  : std::chars_format::scientific;
    std::array<char, 64> buffer{};
    const auto [end, code] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value + 0.0, form);
    const std::string decimal(buffer.data(), end);
    // A third or a 240th is shorter as such.
    const double inverse = std::round(1 / value);
    const bool is_inverse = value > 0 && value < 1 && inverse < 1e6 && 1 / inverse == value;
    return is_inverse && decimal.size() > 8 ? "1/" + std::to_string(std::lround(inverse)) : decimal;
}

std::string show(double value, Dimension dimension) {
    const DimensionInfo& known = info(dimension);
    if (dimension == Dimension::length && value != 0 && std::abs(value) < 0.01) {
        return show(std::round(value * 1e12) / 1e9) + " mm";
    }
    if (dimension == Dimension::time && value != 0 && std::abs(value) < 1e-3) {
        return show(std::round(value * 1e12) / 1e9) + " ms";
    }
    double shown = value / known.unit_value;
    if (dimension == Dimension::angle) {
        // 30 degrees in radians and back is 29.999999999999996; 0.7 radians are no round degrees.
        shown = std::round(shown * 1e9) / 1e9;
        if (show(shown).size() > 8) {
            return show(value) + " rad";
        }
    }
    return known.unit.empty() ? show(shown) : show(shown) + " " + known.unit;
}

bool looks_like_number(std::string_view text) {
    skip_blanks(text);
    return number_length(text) > 0;
}

std::variant<Quantity, std::string> parse_quantity(std::string_view text) {
    skip_blanks(text);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) {
        text.remove_suffix(1);
    }
    const std::size_t length = number_length(text);
    if (length == 0) {
        return "is not a number";
    }
    std::optional<Number> number = take_number(text, length);
    if (!number) {
        return "is too large a number";
    }
    std::string_view behind = text;
    skip_blanks(behind);
    if (!behind.empty() && behind.front() == '/') {
        behind.remove_prefix(1);
        skip_blanks(behind);
        const std::size_t divisor_length = number_length(behind);
        const std::optional<Number> divisor =
            divisor_length > 0 ? take_number(behind, divisor_length) : std::nullopt;
        if (!divisor) {
            return "is not a number";
        }
        if (divisor->value == 0) {
            return "divides by zero";
        }
        number->value /= divisor->value;
        number->exact = number->exact && divisor->exact ? divide(*number->exact, *divisor->exact)
                                                        : std::nullopt;
        text = behind;
    }
    Quantity quantity;
    quantity.value = number->value;
    quantity.exact = number->exact;
    skip_blanks(text);
    if (!text.empty()) {
        std::string wrong = apply_units(quantity, text);
        if (!wrong.empty()) {
            return wrong;
        }
    }
    if (is_angular(quantity.exponents) && !quantity.is_in_degrees) {
        quantity.exact.reset();
    } else if (quantity.exact && !quantity.is_in_degrees) {
        quantity.value = to_double(*quantity.exact).value_or(quantity.value);
    }
    if (!std::isfinite(quantity.value)) {
        return "is too large a number";
    }
    return quantity;
}

}  // namespace carom::pipeline::config
