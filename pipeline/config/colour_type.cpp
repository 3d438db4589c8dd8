#include "pipeline/config/colour_type.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/elementary.h"
#include "pipeline/config/combined_types.h"
#include "pipeline/config/list_types.h"
#include "pipeline/config/number_types.h"

namespace carom::pipeline::config {

namespace {

/// The sRGB decoding function (IEC 61966-2-1:1999).
double decode_srgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : power((encoded + 0.055) / 1.055, 2.4);
}

std::optional<Vec3> parse_hexadecimal_colour(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') {
        return std::nullopt;
    }
    Vec3 colour;
    const char* begin = text.data() + 1;
    for (int channel = 0; channel < 3; ++channel, begin += 2) {
        unsigned value = 0;
        const auto [end, code] = std::from_chars(begin, begin + 2, value, 16);
        if (code != std::errc() || end != begin + 2) {
            return std::nullopt;
        }
        // Rounded, because the last bits of pow differ between libraries.
        colour[channel] = std::round(decode_srgb(value / 255.0) * 1e7) / 1e7;
    }
    return colour;
}

}  // namespace

ValueType<Vec3> colour(Range range) {
    ValueType<Vec3> grey = convert<Vec3>(number(range), [](double value) { return Vec3(value); });
    ValueType<Vec3> hexadecimal;
    hexadecimal.info.kind = TypeInfo::Kind::text;
    hexadecimal.info.noun = "a colour such as \"#1a6b3c\"";
    hexadecimal.info.pattern = "^#[0-9a-fA-F]{6}$";
    const TypeInfo type = hexadecimal.info;
    hexadecimal.read = [type](Reader& reader, const Node& node) {
        std::optional<Vec3> value = parse_hexadecimal_colour(node.text);
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

}  // namespace carom::pipeline::config
