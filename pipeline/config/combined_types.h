// Types of values made of others: alternatives, and values carried into another type.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "pipeline/config/map_spec.h"
#include "pipeline/config/quantity.h"

namespace carom::pipeline::config {

template <class V>
struct Alternative {
    std::function<bool(const Node&)> accepts;
    ValueType<V> type;
};

/// The first alternative that accepts the node reads it.
template <class V>
ValueType<V> any_of(std::vector<Alternative<V>> alternatives) {
    ValueType<V> result;
    result.info.kind = TypeInfo::Kind::any_of;
    for (const Alternative<V>& alternative : alternatives) {
        result.info.elements.push_back(alternative.type.info);
    }
    const TypeInfo type = result.info;
    result.read = [type, alternatives](Reader& reader, const Node& node) -> std::optional<V> {
        for (const Alternative<V>& alternative : alternatives) {
            if (alternative.accepts(node)) {
                return alternative.type.read(reader, node);
            }
        }
        reader.wrong_type(node, describe(type));
        return std::nullopt;
    };
    result.show = alternatives.front().type.show;
    return result;
}

inline bool is_scalar(const Node& node) {
    return node.is_scalar();
}
inline bool is_list(const Node& node) {
    return node.is_sequence();
}
inline bool is_map(const Node& node) {
    return node.is_map();
}
inline bool is_number(const Node& node) {
    return node.is_scalar() && looks_like_number(node.text);
}
inline bool is_word(const Node& node) {
    return node.is_scalar() && !looks_like_number(node.text);
}

/// The value of `from` carried into another type.
template <class To, class From, class Convert>
ValueType<To> convert(ValueType<From> from, Convert function) {
    ValueType<To> result;
    result.info = from.info;
    auto read = from.read;
    result.read = [read, function](Reader& reader, const Node& node) -> std::optional<To> {
        std::optional<From> value = read(reader, node);
        return value ? std::optional<To>(function(std::move(*value))) : std::nullopt;
    };
    return result;
}

}  // namespace carom::pipeline::config
