#include "pipeline/config/unit_pattern.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include <fmt/core.h>

#include "core/text.h"

namespace carom::pipeline::config {

namespace {

constexpr int kHighestPower = 9;  // of the parser
constexpr const char* kTimes = R"((\s*\*\s*|\s+))";
constexpr const char* kDivided = R"(\s*/\s*)";
constexpr const char* kAnyPower = R"((\^?[1-9]|\^-[1-9])?)";

Exponents times(const Exponents& e, int power) {
    return {e.metre * power,  e.kilogram * power, e.second * power,
            e.radian * power, e.decibel * power,  e.lufs * power};
}

Exponents plus(const Exponents& a, const Exponents& b) {
    return {a.metre + b.metre,   a.kilogram + b.kilogram, a.second + b.second,
            a.radian + b.radian, a.decibel + b.decibel,   a.lufs + b.lufs};
}

std::string group(const std::vector<std::string>& names) {
    return "(" + join(names, "|") + ")";
}

/// The exponents of the named units, without duplicates.
std::vector<Exponents> named_unit_exponents() {
    std::vector<Exponents> all;
    for (const std::string& name : unit_names()) {
        const Exponents& exponents = find_unit(name)->exponents;
        if (std::find(all.begin(), all.end(), exponents) == all.end()) {
            all.push_back(exponents);
        }
    }
    return all;
}

/// Matches "^2", "2" or "^-1" after a unit.
std::string power_pattern(int power) {
    if (power == 1) {
        return R"((\^?1)?)";
    }
    return fmt::format("{}{}", power > 0 ? R"(\^?)" : R"(\^-)", std::abs(power));
}

std::string unit_to(const Exponents& exponents, int power) {
    return one_of_units(exponents) + power_pattern(power);
}

/// Matches both forms of a second factor: "m s^-1" and "m/s".
std::string second_factor(const Exponents& exponents, int power) {
    return "(" + (kTimes + unit_to(exponents, power)) + "|" +
           (kDivided + unit_to(exponents, -power)) + ")";
}

void add_powers(std::vector<std::string>& forms, const Exponents& one, const Exponents& wanted) {
    for (int power = -kHighestPower; power <= kHighestPower; ++power) {
        if (power != 0 && times(one, power) == wanted) {
            forms.push_back(unit_to(one, power));
        }
    }
}

void add_products(std::vector<std::string>& forms, const Exponents& one, const Exponents& other,
                  const Exponents& wanted) {
    for (int p = -kHighestPower; p <= kHighestPower; ++p) {
        for (int q = -kHighestPower; q <= kHighestPower; ++q) {
            if (p != 0 && q != 0 && plus(times(one, p), times(other, q)) == wanted) {
                forms.push_back(unit_to(one, p) + second_factor(other, q));
            }
        }
    }
}

}  // namespace

std::string one_of_units(const Exponents& exponents) {
    return group(unit_names(exponents));
}

std::string compound_unit_pattern(Dimension dimension) {
    const Exponents& wanted = info(dimension).exponents;
    const std::string separator = std::string("(") + kTimes + "|" + kDivided + ")";
    const std::string any = group(unit_names()) + kAnyPower;
    std::vector<std::string> forms{any + "(" + separator + any + "){2,}"};
    for (const Exponents& one : named_unit_exponents()) {
        add_powers(forms, one, wanted);
        const std::string same = one_of_units(one) + kAnyPower;
        forms.push_back(same);
        forms.back().append(separator).append(same);
        for (const Exponents& other : named_unit_exponents()) {
            if (!(one == other)) {
                add_products(forms, one, other, wanted);
            }
        }
    }
    return group(forms);
}

}  // namespace carom::pipeline::config
