#include "pipeline/config/list_types.h"

#include <variant>

#include <fmt/core.h>

#include "pipeline/config/combined_types.h"
#include "pipeline/config/number_types.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

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
        values.reserve(kCount);
        for (int i = 0; i < kCount; ++i) {
            values.push_back(vector[i]);
        }
        return list.show(values);
    };
    return result;
}

/// The number of characters between two scalars on one line; 0 otherwise.
int gap_between(const Node& first, const Node& second) {
    const bool is_one_line = first.is_scalar() && second.is_scalar() &&
                             first.place.source == second.place.source &&
                             first.place.line == second.place.line;
    return is_one_line ? second.place.column - first.place.column - first.place.length : 0;
}

bool belongs_to_number(char c) {
    return (c >= '0' && c <= '9') || c == '.';
}

/// Whether the two texts without the comma between them are one number.
bool could_be_one(const Node& first, const Node& second) {
    return !first.text.empty() && !second.text.empty() && belongs_to_number(first.text.back()) &&
           belongs_to_number(second.text.front()) &&
           std::holds_alternative<Quantity>(parse_quantity(first.text + second.text));
}

/// Warns of lists such as "[0,3, 1]", which has three numbers and not two.
void warn_about_decimal_comma(Reader& reader, const Node& node) {
    const Node* before_comma = nullptr;
    const Node* after_comma = nullptr;
    bool has_space = false;  // or a line end after another comma
    for (std::size_t i = 1; i < node.items.size(); ++i) {
        const Node& first = node.items[i - 1];
        const Node& second = node.items[i];
        const int gap = gap_between(first, second);
        has_space = has_space || gap != 1;
        if (gap == 1 && could_be_one(first, second)) {
            before_comma = &first;
            after_comma = &second;
        }
    }
    if (before_comma != nullptr && has_space) {
        reader.warning(before_comma->place,
                       quote(before_comma->text + "," + after_comma->text) +
                           " is read as two numbers; write a decimal point if it is one number, "
                           "or a space after the comma if it is two");
    }
}

}  // namespace

bool check_list(Reader& reader, const Node& node, const TypeInfo& type) {
    if (!node.is_sequence()) {
        reader.wrong_type(node, describe(type));
        return false;
    }
    const int count = static_cast<int>(node.items.size());
    if (count < type.fewest || (type.most >= 0 && count > type.most)) {
        std::string allowed = describe(type);
        if (type.most < 0) {
            allowed +=
                type.fewest == 1 ? " (at least one)" : fmt::format(" (at least {})", type.fewest);
        }
        reader.error(node.place,
                     fmt::format("{} must be {}, not of {}", reader.value_name(), allowed, count));
        return false;
    }
    if (type.elements.at(0).kind == TypeInfo::Kind::quantity) {
        warn_about_decimal_comma(reader, node);
    }
    return true;
}

std::string show_list(const std::vector<std::string>& shown) {
    std::string text = "[";
    for (const std::string& value : shown) {
        text += (text.size() > 1 ? ", " : "") + value;
    }
    return text + "]";
}

ValueType<Vec3> vector3(Dimension dimension, Range range) {
    return vector_type<Vec3, 3>(dimension, range);
}

ValueType<Vec2> vector2(Dimension dimension, Range range) {
    return vector_type<Vec2, 2>(dimension, range);
}

ValueType<Coordinates> coordinates(Dimension dimension, Range range) {
    return convert<Coordinates>(list_of(quantity(dimension, range), 2, 3),
                                [](const std::vector<double>& values) {
                                    const bool has_z = values.size() == 3;
                                    const double z = has_z ? values[2] : 0.0;
                                    return Coordinates{Vec3(values[0], values[1], z), has_z};
                                });
}

}  // namespace carom::pipeline::config
