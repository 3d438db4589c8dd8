// Value types that are made from others: alternatives and conversions.
#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
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

/// An alternative without its C++ type.
struct AnyAlternative {
    std::function<bool(const Node&)> accepts;
    TypeInfo info;
    ReadFunction read_into;
};

/// The type that consists of the alternatives.
[[nodiscard]] TypeInfo any_of_info(const std::vector<AnyAlternative>& alternatives);

/// A function that reads with the first alternative that accepts the node.
[[nodiscard]] ReadFunction read_any_of(std::vector<AnyAlternative> alternatives);

/// A type whose values are read by the first alternative that accepts the node.
template <class V>
ValueType<V> any_of(std::initializer_list<Alternative<V>> alternatives) {
    std::vector<AnyAlternative> all;
    for (const Alternative<V>& alternative : alternatives) {
        all.push_back(
            {alternative.accepts, alternative.type.info, alternative.type.read.read_into()});
    }
    return {any_of_info(all), ValueReader<V>(read_any_of(std::move(all))),
            alternatives.begin()->type.show};
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

/// Accepts only this word, so that other words are told all alternatives. `word`: a literal.
inline std::function<bool(const Node&)> is_exactly(const char* word) {
    return [word](const Node& node) { return node.is_scalar() && node.text == word; };
}

/// A type whose values are those of `from`, converted to another C++ type.
template <class To, class From, class Convert>
ValueType<To> convert(const ValueType<From>& from, Convert function) {
    ValueType<To> result;
    result.info = from.info;
    result.read = [read = from.read, function](Reader& reader,
                                               const Node& node) -> std::optional<To> {
        std::optional<From> value = read(reader, node);
        return value ? std::optional<To>(function(std::move(*value))) : std::nullopt;
    };
    return result;
}

}  // namespace carom::pipeline::config
