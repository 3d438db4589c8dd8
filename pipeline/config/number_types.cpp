#include "pipeline/config/number_types.h"

#include <charconv>
#include <cmath>
#include <string>
#include <variant>

#include <fmt/core.h>

#include "pipeline/config/combined_types.h"
#include "pipeline/config/show_quantity.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

void report_range(Reader& reader, const Node& node, const TypeInfo& type) {
    reader.error(node.place, reader.value_name() + " must be " +
                                 describe(type.range, type.dimension) + ", not " +
                                 quote(node.text));
}

std::string show_integer(std::int64_t value) {
    return fmt::format("{}", value);
}

/// "'direction' is an angle and needs a unit; write '30 deg'"
void report_missing_unit(Reader& reader, const Node& node, const TypeInfo& type, double value) {
    constexpr double kTurn = 6.283185307179586;
    constexpr double kDensest = 23;      // g/cm^3; osmium has 22.6
    constexpr double kStiffest = 1'200;  // GPa; diamond has 1050 to 1200
    const auto with = [&](const std::string& unit) { return quote(node.text + " " + unit); };
    std::string forms = with(type.needed_unit);
    if (type.dimension == Dimension::angle && std::abs(value) <= kTurn) {
        forms += " or " + with("rad");
    } else if (type.dimension == Dimension::angular_speed) {
        forms += " or " + with("rpm");
    } else if (type.dimension == Dimension::density && value < kDensest) {
        forms += " or " + with("g/cm^3");
    } else if (type.dimension == Dimension::length && std::abs(value) < 1) {
        forms += " or " + with("m");
    } else if (type.dimension == Dimension::pressure && value >= kStiffest) {
        forms = with("Pa");
    }
    reader.error(node.place, reader.value_name() + " is " + info(type.dimension).name +
                                 " and needs a unit; write " + forms);
}

/// The allowed units, for an unknown unit without a similar known one.
std::string units_help(const QuantityProblem& problem, const TypeInfo& type) {
    const bool is_unit = problem.kind == QuantityProblem::Kind::unknown_unit;
    if (!is_unit || !problem.message.suggestion.empty()) {
        return {};
    }
    const std::string& units = info(type.dimension).units;
    return units.empty() ? " (this number has no unit)" : " (the units are " + units + ")";
}

}  // namespace

TypeInfo quantity_info(Dimension dimension, const Range& range) {
    TypeInfo type;
    type.kind = TypeInfo::Kind::quantity;
    type.dimension = dimension;
    type.range = range;
    type.needed_unit = info(dimension).needs_unit ? info(dimension).unit : "";
    return type;
}

std::optional<Quantity> read_quantity(Reader& reader, const Node& node, const TypeInfo& type) {
    if (!node.is_scalar()) {
        reader.wrong_type(node, describe(type));
        return std::nullopt;
    }
    const std::variant<Quantity, QuantityProblem> parsed = parse_quantity(node.text);
    if (const auto* problem = std::get_if<QuantityProblem>(&parsed)) {
        if (problem->kind == QuantityProblem::Kind::not_a_number) {
            reader.wrong_type(node, describe(type));
        } else {
            Message message = quote(node.text) + " " + problem->message;
            message.text += units_help(*problem, type);
            reader.error(node.place, std::move(message));
        }
        return std::nullopt;
    }
    const Quantity& value = std::get<Quantity>(parsed);
    if (value.has_unit && value.exponents != info(type.dimension).exponents) {
        const std::string given = name_of(value.exponents);
        reader.error(node.place, reader.value_name() + " must be " + describe(type) + ", not " +
                                     given + " (" + quote(node.text) + ")");
        return std::nullopt;
    }
    const bool is_zero = value.value == 0 && !info(type.dimension).is_logarithmic;
    if (!value.has_unit && !is_zero && !type.needed_unit.empty()) {
        report_missing_unit(reader, node, type, value.value);
        return std::nullopt;
    }
    if (!type.range.contains(value.value)) {
        report_range(reader, node, type);
        return std::nullopt;
    }
    return value;
}

namespace {

ValueType<double> quantity_of(const TypeInfo& type) {
    ValueType<double> result;
    result.info = type;
    result.read = [type](Reader& reader, const Node& node) -> std::optional<double> {
        const std::optional<Quantity> value = read_quantity(reader, node, type);
        return value ? std::optional(value->value) : std::nullopt;
    };
    result.show = [dimension = type.dimension](const double& value) {
        return show(value, dimension);
    };
    return result;
}

}  // namespace

ValueType<double> quantity(Dimension dimension, Range range) {
    return quantity_of(quantity_info(dimension, range));
}

ValueType<double> lens_length(Range range) {
    TypeInfo type = quantity_info(Dimension::length, range);
    type.needed_unit = "mm";
    return quantity_of(type);
}

ValueType<double> elastic_modulus(Range range) {
    TypeInfo type = quantity_info(Dimension::pressure, range);
    type.needed_unit = "GPa";
    return quantity_of(type);
}

Rational to_rational(const Quantity& quantity) {
    // Larger terms could overflow when they are multiplied. Real rates and times have smaller ones.
    constexpr std::int64_t kLargest = 1'000'000'000;
    const std::optional<Fraction>& exact = quantity.exact;
    if (exact && std::abs(exact->numerator) <= kLargest && exact->denominator <= kLargest) {
        return {exact->numerator, exact->denominator};
    }
    const double rounded = std::round(quantity.value * kLargest) / kLargest;
    return rounded == 0 ? Rational() : Rational::nearest(rounded);
}

ValueType<Rational> exact(Dimension dimension, Range range) {
    const TypeInfo type = quantity_info(dimension, range);
    ValueType<Rational> result;
    result.info = type;
    result.read = [type](Reader& reader, const Node& node) -> std::optional<Rational> {
        const std::optional<Quantity> value = read_quantity(reader, node, type);
        if (!value) {
            return std::nullopt;
        }
        return to_rational(*value);
    };
    result.show = [dimension](const Rational& value) {
        const std::string& unit = info(dimension).unit;
        return unit.empty() ? value.to_string() : value.to_string() + " " + unit;
    };
    return result;
}

ValueType<std::int64_t> integer64(std::int64_t low, std::int64_t high) {
    ValueType<std::int64_t> result;
    result.info.kind = TypeInfo::Kind::integer;
    result.info.range = between(static_cast<double>(low), static_cast<double>(high));
    const TypeInfo type = result.info;
    result.read = [=](Reader& reader, const Node& node) -> std::optional<std::int64_t> {
        if (!node.is_scalar()) {
            reader.wrong_type(node, describe(type));
            return std::nullopt;
        }
        std::int64_t value = 0;
        const char* const begin = node.text.data();
        const char* const text_end = begin + node.text.size();
        const auto [end, code] = std::from_chars(begin, text_end, value);
        const bool is_too_large = code == std::errc::result_out_of_range;
        if (end != text_end || (code != std::errc() && !is_too_large)) {
            reader.wrong_type(node, describe(type));
            return std::nullopt;
        }
        if (is_too_large || value < low || value > high) {
            reader.error(node.place, fmt::format("{} must be at least {} and at most {}, not {}",
                                                 reader.value_name(), low, high, quote(node.text)));
            return std::nullopt;
        }
        return value;
    };
    result.show = show_integer;
    return result;
}

ValueType<int> integer(int low, int high) {
    ValueType<int> result = convert<int>(
        integer64(low, high), [](std::int64_t value) { return static_cast<int>(value); });
    result.show = [](const int& value) { return show_integer(value); };
    return result;
}

}  // namespace carom::pipeline::config
