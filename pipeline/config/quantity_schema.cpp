#include "pipeline/config/quantity_schema.h"

#include <vector>

#include "pipeline/config/decimal_pattern.h"
#include "pipeline/config/unit_pattern.h"

namespace carom::pipeline::config {

namespace {

constexpr const char* kDigits = R"(([0-9]+\.?[0-9]*|\.[0-9]+))";
constexpr const char* kExponent = "([eE][+-]?[0-9]+)";
constexpr const char* kPowerOne = R"((\^?1)?)";  // after a unit

/// A number without a sign: "0.5", "5e-1".
std::string unsigned_number() {
    return std::string(kDigits) + kExponent + "?";
}

/// Matches "1e5" and "1/48", which cannot be compared with a range by a pattern.
std::string not_decimal(const std::string& sign) {
    const std::string any_fraction =
        "[+-]?" + unsigned_number() + R"(\s*/\s*-)" + unsigned_number();
    return "(" + sign + kDigits + kExponent + "|" + sign + unsigned_number() + R"(\s*/\s*\+?)" +
           unsigned_number() + "|" + any_fraction + ")";
}

Range in_unit(const Range& range, double unit_value) {
    Range result = range;
    if (range.low) {
        result.low = *range.low / unit_value;
    }
    if (range.high) {
        result.high = *range.high / unit_value;
    }
    return result;
}

std::string whole(const std::string& pattern) {
    return R"(^\s*)" + pattern + R"(\s*$)";
}

}  // namespace

std::string dimension_pattern(Dimension dimension, bool needs_unit) {
    const std::string number =
        "[+-]?" + unsigned_number() + R"((\s*/\s*[+-]?)" + unsigned_number() + ")?";
    if (dimension == Dimension::none) {
        return whole(number);
    }
    std::string units = compound_unit_pattern(dimension);
    const Exponents& exponents = info(dimension).exponents;
    if (!unit_names(exponents).empty()) {
        units = "(" + one_of_units(exponents) + kPowerOne + "|" + units + ")";
    }
    const std::string with_unit = number + R"(\s*)" + units;
    if (info(dimension).is_logarithmic) {
        return whole(with_unit);
    }
    return whole(needs_unit ? "(" + with_unit + R"(|[+-]?0+(\.0*)?))"
                            : number + R"((\s*)" + units + ")?");
}

std::string range_pattern(const TypeInfo& type) {
    const std::vector<std::string> own = unit_names(info(type.dimension).exponents);
    const std::string sign = sign_pattern(type.range);
    std::string forms = decimal_pattern(type.range);
    if (type.dimension == Dimension::none) {
        return whole("(" + forms + "|" + not_decimal(sign) + ")");
    }
    for (const std::string& unit : own) {
        forms += "|" + decimal_pattern(in_unit(type.range, find_unit(unit)->value)) + R"(\s*)" +
                 unit + kPowerOne;
    }
    const std::string of_own =
        own.empty() ? ""
                    : "(?!" + one_of_units(info(type.dimension).exponents) + kPowerOne + R"(\s*$))";
    forms += "|" + sign + kDigits + R"(\s*)" + of_own + "[a-zA-Z].*";
    forms += "|" + not_decimal(sign) + R"((\s*[a-zA-Z].*)?)";
    return whole("(" + forms + ")");
}

}  // namespace carom::pipeline::config
