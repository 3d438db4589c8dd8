// Reads the subset of USD's text form that carom writes.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace carom::testing {

/// A value: a word or number, a text, a path <...> or @...@, or a list in [] or ().
struct UsdaValue {
    std::string text;
    std::vector<UsdaValue> items;

    [[nodiscard]] double number() const { return std::stod(text); }
    [[nodiscard]] std::vector<double> numbers() const;
};

struct UsdaAttribute {
    std::string type;  // "point3f[]", "rel"; qualifiers such as "uniform" before it
    UsdaValue value;
    std::vector<std::pair<double, UsdaValue>> samples;  // by time code; if it has timeSamples
};

struct UsdaPrim {
    std::string type;
    std::string name;
    std::map<std::string, UsdaValue> metadata;
    std::map<std::string, UsdaAttribute> attributes;
    std::vector<UsdaPrim> children;

    [[nodiscard]] const UsdaPrim* child(std::string_view name) const;
    /// The prim at a path such as "</shot/materials/cloth>", with this prim as the root.
    [[nodiscard]] const UsdaPrim* at(std::string_view path) const;
};

/// Returns a prim whose metadata is the file's header and whose children are the file's prims.
/// Throws std::runtime_error with the line of a syntax error.
[[nodiscard]] UsdaPrim read_usda(std::string_view text);

}  // namespace carom::testing
