// The types of words.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/config/map_spec.h"

namespace carom::pipeline::config {

[[nodiscard]] ValueType<bool> boolean();

/// Any word; `noun` describes its meaning.
[[nodiscard]] ValueType<std::string> text(std::string noun);

/// Any word, of which `suggested` and the keys of the shot's map `more` ("conditions.cloth") are
/// suggested.
[[nodiscard]] ValueType<std::string> word(std::vector<std::string> suggested, std::string more);

/// The name of something in the shot; it is checked after everything has been read.
[[nodiscard]] ValueType<std::string> name_of(ReferenceKind kind);

/// The absolute path of an existing file.
[[nodiscard]] ValueType<std::string> file(FileKind kind);

/// The index of the scalar in `type.choices`.
[[nodiscard]] std::optional<std::size_t> read_choice(Reader& reader, const Node& node,
                                                     const TypeInfo& type);

/// One of a few words.
template <class E>
ValueType<E> choice(std::vector<std::pair<std::string, E>> choices) {
    TypeInfo type;
    type.kind = TypeInfo::Kind::choice;
    for (const auto& [word, value] : choices) {
        type.choices.push_back(word);
    }
    ValueType<E> result;
    result.info = type;
    result.read = [type, choices](Reader& reader, const Node& node) -> std::optional<E> {
        const std::optional<std::size_t> index = read_choice(reader, node, type);
        return index ? std::optional<E>(choices[*index].second) : std::nullopt;
    };
    result.show = [choices](const E& shown) {
        for (const auto& [word, value] : choices) {
            if (value == shown) {
                return word;
            }
        }
        return std::string();
    };
    return result;
}

}  // namespace carom::pipeline::config
