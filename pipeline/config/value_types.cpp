#include "pipeline/config/value_types.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

constexpr std::size_t kLongestName = 64;

TypeInfo quantity_info(Dimension dimension, const Range& range) {
    TypeInfo type;
    type.kind = TypeInfo::Kind::quantity;
    type.dimension = dimension;
    type.range = range;
    return type;
}

void report_range(Reader& reader, const Node& node, const TypeInfo& type) {
    reader.error(node.place, reader.value_name() + " must be " +
                                 describe(type.range, type.dimension) + ", not " +
                                 quote(node.text));
}

std::string show_integer(std::int64_t value) {
    return std::to_string(value);
}

/// sRGB's decoding function (IEC 61966-2-1:1999).
double decode_srgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::optional<Vec3> parse_hexadecimal_colour(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') {
        return std::nullopt;
    }
    Vec3 colour;
    for (int channel = 0; channel < 3; ++channel) {
        unsigned value = 0;
        const char* begin = text.data() + 1 + 2 * channel;
        const auto [end, code] = std::from_chars(begin, begin + 2, value, 16);
        if (code != std::errc() || end != begin + 2) {
            return std::nullopt;
        }
        // Rounded, since pow differs in its last bits between libraries.
        colour[channel] = std::round(decode_srgb(value / 255.0) * 1e7) / 1e7;
    }
    return colour;
}

/// For an unknown unit without a near one: those that can stand here.
std::string units_help(const std::string& wrong, const TypeInfo& type) {
    const bool is_unit = wrong.find("unknown unit") != std::string::npos;
    if (!is_unit || wrong.find("did you mean") != std::string::npos) {
        return {};
    }
    const std::string& units = info(type.dimension).units;
    return units.empty() ? " (it is a plain number)" : " (it may be in " + units + ")";
}

std::string noun_of(ReferenceKind kind) {
    switch (kind) {
        case ReferenceKind::ball:
            return "a ball";
        case ReferenceKind::body:
        case ReferenceKind::simulated:
        case ReferenceKind::moving:
            return "a ball or moving object";
        case ReferenceKind::touchable:
            return "an object or surface";
        case ReferenceKind::placed:
            return "a ball or object";
        case ReferenceKind::material:
            return "a material";
    }
    return {};
}

template <class V, int kCount>
ValueType<V> vector_type(Dimension dimension, const Range& range) {
    const ValueType<std::vector<double>> list = list_of(quantity(dimension, range), kCount, kCount);
    ValueType<V> result = convert<V>(list, [](const std::vector<double>& values) {
        V vector;
        for (int i = 0; i < kCount; ++i) {
            vector[i] = values[i];
        }
        return vector;
    });
    result.show = [list](const V& vector) {
        std::vector<double> values;
        for (int i = 0; i < kCount; ++i) {
            values.push_back(vector[i]);
        }
        return list.show(values);
    };
    return result;
}

}  // namespace

std::optional<Quantity> read_quantity(Reader& reader, const Node& node, const TypeInfo& type) {
    if (!node.is_scalar()) {
        reader.wrong_type(node, describe(type));
        return std::nullopt;
    }
    const std::variant<Quantity, std::string> parsed = parse_quantity(node.text);
    if (const std::string* wrong = std::get_if<std::string>(&parsed)) {
        if (*wrong == "is not a number") {
            reader.wrong_type(node, describe(type));
        } else {
            reader.error(node.place, quote(node.text) + " " + *wrong + units_help(*wrong, type));
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
    if (!type.range.contains(value.value)) {
        report_range(reader, node, type);
        return std::nullopt;
    }
    return value;
}

ValueType<double> quantity(Dimension dimension, Range range) {
    const TypeInfo type = quantity_info(dimension, range);
    ValueType<double> result;
    result.info = type;
    result.read = [type](Reader& reader, const Node& node) -> std::optional<double> {
        const std::optional<Quantity> value = read_quantity(reader, node, type);
        return value ? std::optional(value->value) : std::nullopt;
    };
    result.show = [dimension](const double& value) { return show(value, dimension); };
    return result;
}

Rational to_rational(const Quantity& quantity) {
    // Larger terms than any real rate or time has would overflow where they are multiplied.
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
            reader.error(node.place, reader.value_name() + " must be at least " +
                                         std::to_string(low) + " and at most " +
                                         std::to_string(high) + ", not " + quote(node.text));
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

ValueType<bool> boolean() {
    ValueType<bool> result;
    result.info.kind = TypeInfo::Kind::boolean;
    const TypeInfo type = result.info;
    result.read = [type](Reader& reader, const Node& node) -> std::optional<bool> {
        // The core schema of YAML 1.2 (section 10.3.2) knows no yes, no, on and off.
        const bool is_plain = node.is_scalar() && !node.quoted;
        if (is_plain && (node.text == "true" || node.text == "True" || node.text == "TRUE")) {
            return true;
        }
        if (is_plain && (node.text == "false" || node.text == "False" || node.text == "FALSE")) {
            return false;
        }
        reader.wrong_type(node, describe(type));
        return std::nullopt;
    };
    result.show = [](const bool& value) { return value ? "true" : "false"; };
    return result;
}

ValueType<std::string> text(std::string noun) {
    ValueType<std::string> result;
    result.info.kind = TypeInfo::Kind::text;
    result.info.noun = std::move(noun);
    const TypeInfo type = result.info;
    result.read = [type](Reader& reader, const Node& node) -> std::optional<std::string> {
        if (!node.is_scalar()) {
            reader.wrong_type(node, describe(type));
            return std::nullopt;
        }
        return node.text;
    };
    result.show = [](const std::string& value) { return value; };
    return result;
}

ValueType<std::string> name_of(ReferenceKind kind) {
    ValueType<std::string> result;
    result.info.kind = TypeInfo::Kind::name;
    result.info.noun = noun_of(kind);
    const TypeInfo type = result.info;
    result.read = [type, kind](Reader& reader, const Node& node) -> std::optional<std::string> {
        if (!node.is_scalar()) {
            reader.wrong_type(node, describe(type));
            return std::nullopt;
        }
        reader.refer(kind, node);
        return node.text;
    };
    result.show = [](const std::string& value) { return value; };
    return result;
}

ValueType<std::string> file() {
    ValueType<std::string> result;
    result.info.kind = TypeInfo::Kind::file;
    const TypeInfo type = result.info;
    result.read = [type](Reader& reader, const Node& node) -> std::optional<std::string> {
        if (!node.is_scalar()) {
            reader.wrong_type(node, describe(type));
            return std::nullopt;
        }
        std::string path = reader.file(node);
        return path.empty() ? std::nullopt : std::optional(std::move(path));
    };
    return result;
}

std::optional<std::size_t> read_choice(Reader& reader, const Node& node, const TypeInfo& type) {
    if (!node.is_scalar()) {
        reader.wrong_type(node, describe(type));
        return std::nullopt;
    }
    const auto found = std::find(type.choices.begin(), type.choices.end(), node.text);
    if (found == type.choices.end()) {
        reader.error(node.place, reader.value_name() + " must be " + describe(type) + ", not " +
                                     quote(node.text) + hint(node.text, type.choices));
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - type.choices.begin());
}

bool check_list(Reader& reader, const Node& node, const TypeInfo& type) {
    if (!node.is_sequence()) {
        reader.wrong_type(node, describe(type));
        return false;
    }
    const int count = static_cast<int>(node.items.size());
    if (count < type.fewest || (type.most >= 0 && count > type.most)) {
        const std::string allowed =
            type.most < 0 && type.fewest == 1 ? describe(type) + " (at least one)" : describe(type);
        reader.error(node.place, reader.value_name() + " must be " + allowed + ", not of " +
                                     std::to_string(count));
        return false;
    }
    return true;
}

ValueType<Vec3> vector3(Dimension dimension, Range range) {
    return vector_type<Vec3, 3>(dimension, range);
}

ValueType<Vec2> vector2(Dimension dimension, Range range) {
    return vector_type<Vec2, 2>(dimension, range);
}

ValueType<Coordinates> coordinates(Dimension dimension) {
    return convert<Coordinates>(list_of(quantity(dimension), 2, 3),
                                [](const std::vector<double>& values) {
                                    const bool has_z = values.size() == 3;
                                    const double z = has_z ? values[2] : 0.0;
                                    return Coordinates{Vec3(values[0], values[1], z), has_z};
                                });
}

ValueType<Vec3> colour(Range range) {
    ValueType<Vec3> grey = convert<Vec3>(number(range), [](double value) { return Vec3(value); });
    ValueType<Vec3> hexadecimal;
    hexadecimal.info.kind = TypeInfo::Kind::text;
    hexadecimal.info.noun = "a colour such as \"#1a6b3c\"";
    const TypeInfo type = hexadecimal.info;
    hexadecimal.read = [type](Reader& reader, const Node& node) {
        const std::optional<Vec3> value = parse_hexadecimal_colour(node.text);
        if (!value) {
            reader.wrong_type(node, describe(type));
        }
        return value;
    };
    ValueType<Vec3> result = any_of<Vec3>(
        {{is_list, vector3(Dimension::none, range)}, {is_number, grey}, {is_word, hexadecimal}});
    result.info.noun = "colour";
    result.info.range = range;
    return result;
}

bool check_name(Reader& reader, const std::string& name, const Place& place,
                const std::string& noun) {
    const auto is_allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-';
    };
    const bool starts_well = !name.empty() && is_allowed(name[0]) && name[0] != '-' &&
                             !(name[0] >= '0' && name[0] <= '9');
    if (!starts_well || name.size() > kLongestName ||
        !std::all_of(name.begin(), name.end(), is_allowed)) {
        reader.error(place, quote(name) + " cannot be the name of a " + noun +
                                ": a letter, then letters, digits, _ and -, at most 64 in all");
        return false;
    }
    static const std::vector<std::string> kReserved{"all", "auto", "none", "true", "false", "null"};
    if (std::find(kReserved.begin(), kReserved.end(), name) != kReserved.end()) {
        reader.error(place,
                     quote(name) + " has a meaning of its own and cannot be the name of a " + noun);
        return false;
    }
    return true;
}

}  // namespace carom::pipeline::config
