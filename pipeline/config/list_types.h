// The types of lists.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/vectors.h"
#include "pipeline/config/map_spec.h"

namespace carom::pipeline::config {

/// Checks that `node` is a list of the allowed length, and reports a problem otherwise.
[[nodiscard]] bool check_list(Reader& reader, const Node& node, const TypeInfo& type);

/// "[1, 2]".
[[nodiscard]] std::string show_list(const std::vector<std::string>& shown);

/// A list of `fewest` to `most` values of one type; most = -1: no upper limit.
template <class V>
ValueType<std::vector<V>> list_of(const ValueType<V>& element, int fewest = 0, int most = -1) {
    ValueType<std::vector<V>> result;
    result.info.kind = TypeInfo::Kind::list;
    result.info.elements = {element.info};
    result.info.fewest = fewest;
    result.info.most = most;
    const TypeInfo type = result.info;
    result.read = [type, read = element.read](Reader& reader,
                                              const Node& node) -> std::optional<std::vector<V>> {
        if (!check_list(reader, node, type)) {
            return std::nullopt;
        }
        std::vector<V> values;
        for (std::size_t i = 0; i < node.items.size(); ++i) {
            const Reader::Scope scope(reader, i, node.items[i].place);
            if (std::optional<V> value = read(reader, node.items[i])) {
                values.push_back(std::move(*value));
            }
        }
        return values.size() == node.items.size() ? std::optional(std::move(values)) : std::nullopt;
    };
    result.show = [show = element.show](const std::vector<V>& values) {
        std::vector<std::string> shown;
        shown.reserve(values.size());
        for (const V& value : values) {
            shown.push_back(show ? show(value) : std::string());
        }
        return show_list(shown);
    };
    return result;
}

[[nodiscard]] ValueType<Vec3> vector3(Dimension dimension, Range range = {});
[[nodiscard]] ValueType<Vec2> vector2(Dimension dimension, Range range = {});

/// Two or three coordinates; the default of z is 0.
struct Coordinates {
    Vec3 value;
    bool has_z = false;
};
[[nodiscard]] ValueType<Coordinates> coordinates(Dimension dimension, Range range = {});

}  // namespace carom::pipeline::config
