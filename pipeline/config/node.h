// A YAML document as a tree in which every key and value has its place.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/config/source_set.h"

namespace carom::pipeline::config {

struct Entry;

struct Node {
    enum class Kind { null, scalar, sequence, map };

    Kind kind = Kind::null;
    Place place;
    bool quoted = false;         // scalar in quotes or in a block, so never true or false
    bool is_repeated = false;    // made by a `repeat` (repeat.h): `place` is that of the original,
                                 // which stands for others, too
    std::string text;            // scalar
    std::vector<Node> items;     // sequence
    std::vector<Entry> entries;  // map, in order, keys unique

    [[nodiscard]] bool is_null() const { return kind == Kind::null; }
    [[nodiscard]] bool is_scalar() const { return kind == Kind::scalar; }
    [[nodiscard]] bool is_sequence() const { return kind == Kind::sequence; }
    [[nodiscard]] bool is_map() const { return kind == Kind::map; }

    /// The entry of that key, or nullptr.
    [[nodiscard]] const Entry* find(std::string_view key) const;
    [[nodiscard]] Entry* find(std::string_view key);
};

struct Entry {
    std::string key;
    Place key_place;
    Node value;
};

inline const Entry* Node::find(std::string_view key) const {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const Entry& entry) { return entry.key == key; });
    return found == entries.end() ? nullptr : &*found;
}

inline Entry* Node::find(std::string_view key) {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const Entry& entry) { return entry.key == key; });
    return found == entries.end() ? nullptr : &*found;
}

}  // namespace carom::pipeline::config
