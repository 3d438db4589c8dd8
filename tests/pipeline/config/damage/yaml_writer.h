// A YAML document as a tree, and its text in a random style.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/random_films/dice.h"

namespace carom::testing {

struct Yaml {
    enum class Kind { scalar, list, map };

    Kind kind = Kind::map;
    std::string text;      // scalar
    bool is_text = false;  // scalar: free text or a name, which may be in quotes
    std::vector<Yaml> items;
    std::vector<std::pair<std::string, Yaml>> entries;

    Yaml() = default;
    /// A number, a quantity or a word of the format.
    Yaml(const char* scalar) : kind(Kind::scalar), text(scalar) {}
    Yaml(std::string scalar) : kind(Kind::scalar), text(std::move(scalar)) {}

    [[nodiscard]] static Yaml free_text(std::string scalar);
    [[nodiscard]] static Yaml list(std::vector<Yaml> items);

    /// Adds an entry to a map.
    Yaml& add(std::string key, Yaml value);

    /// Whether it is a map or holds one.
    [[nodiscard]] bool holds_map() const;
};

/// The map as a document in a random style: block or flow, indented by one to four spaces, with or
/// without quotes, comments and empty lines.
[[nodiscard]] std::string write_yaml(const Yaml& map, Dice& dice);

}  // namespace carom::testing
