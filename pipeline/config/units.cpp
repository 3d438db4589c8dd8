#include "pipeline/config/units.h"

#include <array>
#include <numbers>

namespace carom::pipeline::config {

namespace {

constexpr Exponents kLength{1, 0, 0, 0};
constexpr Exponents kMass{0, 1, 0, 0};
constexpr Exponents kTime{0, 0, 1, 0};
constexpr Exponents kAngle{0, 0, 0, 1};
constexpr Exponents kForce{1, 1, -2, 0};
constexpr Exponents kSpeed{1, 0, -1, 0};
constexpr Exponents kFrequency{0, 0, -1, 0};
constexpr Exponents kPressure{-1, 1, -2, 0};
constexpr Exponents kLevel{0, 0, 0, 0, 1, 0};
constexpr Exponents kLoudness{0, 0, 0, 0, 0, 1};

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
    Unit{"deg", kAngle, std::numbers::pi / 180, {1, 1}, true},
    Unit{"turn", kAngle, 2 * std::numbers::pi, {360, 1}, true},
    Unit{"rpm", {0, 0, -1, 1}, 2 * std::numbers::pi / 60},
    Unit{"mph", kSpeed, 0.44704, {1397, 3125}},
    Unit{"N", kForce, 1, {1, 1}},
    Unit{"mN", kForce, 0.001, {1, 1000}},
    Unit{"kN", kForce, 1000, {1000, 1}},
    Unit{"Hz", kFrequency, 1, {1, 1}},
    Unit{"kHz", kFrequency, 1000, {1000, 1}},
    Unit{"fps", kFrequency, 1, {1, 1}},
    Unit{"Pa", kPressure, 1, {1, 1}},
    Unit{"kPa", kPressure, 1e3, {1000, 1}},
    Unit{"MPa", kPressure, 1e6, {1000000, 1}},
    Unit{"GPa", kPressure, 1e9, {1000000000, 1}},
    Unit{"dB", kLevel, 1, {1, 1}},
    Unit{"LUFS", kLoudness, 1, {1, 1}},
};

const std::array kDimensions{
    DimensionInfo{Dimension::none, {}, "a plain number", "plain numbers", "", "", 1},
    DimensionInfo{Dimension::length, kLength, "a length", "lengths", "m, cm, mm, in, ft", "m", 1},
    DimensionInfo{Dimension::mass, kMass, "a mass", "masses", "kg, g, oz, lb", "kg", 1},
    DimensionInfo{Dimension::time, kTime, "a time", "times", "s, ms, min", "s", 1},
    DimensionInfo{Dimension::angle, kAngle, "an angle", "angles", "rad, deg, turn", "deg",
                  std::numbers::pi / 180, true},
    DimensionInfo{Dimension::speed, kSpeed, "a speed", "speeds", "m/s, km/h, mph", "m/s", 1},
    DimensionInfo{Dimension::angular_speed,
                  {0, 0, -1, 1},
                  "an angular velocity",
                  "angular velocities",
                  "rad/s, deg/s, rpm",
                  "rad/s",
                  1,
                  true},
    DimensionInfo{Dimension::acceleration,
                  {1, 0, -2, 0},
                  "an acceleration",
                  "accelerations",
                  "m/s^2",
                  "m/s^2",
                  1},
    DimensionInfo{Dimension::density,
                  {-3, 1, 0, 0},
                  "a density",
                  "densities",
                  "kg/m^3, g/cm^3",
                  "kg/m^3",
                  1,
                  true},
    DimensionInfo{Dimension::force, kForce, "a force", "forces", "N, mN", "N", 1},
    DimensionInfo{Dimension::torque, {2, 1, -2, 0}, "a torque", "torques", "N m", "N m", 1},
    DimensionInfo{Dimension::impulse, {1, 1, -1, 0}, "an impulse", "impulses", "N s", "N s", 1},
    DimensionInfo{Dimension::frequency, kFrequency, "a frequency", "frequencies", "Hz, fps", "Hz",
                  1},
    DimensionInfo{Dimension::pressure, kPressure, "a pressure", "pressures", "Pa, kPa, MPa, GPa",
                  "Pa", 1, true},
    DimensionInfo{Dimension::level, kLevel, "a level", "levels", "dB", "dB", 1, true, true},
    DimensionInfo{Dimension::loudness, kLoudness, "a loudness", "loudnesses", "LUFS", "LUFS", 1,
                  true, true},
};

}  // namespace

const Unit* find_unit(std::string_view name) {
    for (const Unit& unit : kUnits) {
        if (unit.name == name) {
            return &unit;
        }
    }
    return nullptr;
}

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

}  // namespace carom::pipeline::config
