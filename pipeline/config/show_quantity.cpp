#include "pipeline/config/show_quantity.h"

#include <cmath>

#include <fmt/core.h>

namespace carom::pipeline::config {

std::string show(double value) {
    const std::string decimal = fmt::format("{}", value + 0.0);  // + 0.0: -0 becomes 0
    // 1/3 or 1/240 is shorter than the decimal.
    const double inverse = std::round(1 / value);
    const bool is_inverse = value > 0 && value < 1 && inverse < 1e6 && 1 / inverse == value;
    return is_inverse && decimal.size() > 8 ? fmt::format("1/{}", std::lround(inverse)) : decimal;
}

namespace {

/// In the largest of the units of which it has at least one.
std::string show_pressure(double value) {
    for (const char* name : {"GPa", "MPa", "kPa"}) {
        const double unit = find_unit(name)->value;
        if (std::abs(value) >= unit) {
            return show(value / unit) + " " + name;
        }
    }
    return show(value) + " Pa";
}

}  // namespace

std::string show(double value, Dimension dimension) {
    const DimensionInfo& known = info(dimension);
    if (dimension == Dimension::length && value != 0 && std::abs(value) < 0.01) {
        return show(std::round(value * 1e12) / 1e9) + " mm";
    }
    if (dimension == Dimension::time && value != 0 && std::abs(value) < 1e-3) {
        return show(std::round(value * 1e12) / 1e9) + " ms";
    }
    if (dimension == Dimension::pressure) {
        return show_pressure(value);
    }
    double shown = value / known.unit_value;
    if (dimension == Dimension::angle) {
        // 30 degrees in radians and back is 29.999999999999996; 0.7 radians are not a round number
        // of degrees.
        shown = std::round(shown * 1e9) / 1e9;
        if (show(shown).size() > 8) {
            return show(value) + " rad";
        }
    }
    return known.unit.empty() ? show(shown) : show(shown) + " " + known.unit;
}

}  // namespace carom::pipeline::config
