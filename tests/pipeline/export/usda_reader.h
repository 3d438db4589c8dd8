// A reader of the part of USD's text form that carom writes.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace carom::testing {

/// A value: a word or number, a text, a path <...> or @...@, or a list ([] and () alike).
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
    /// "</shot/materials/cloth>" below this one as the root.
    [[nodiscard]] const UsdaPrim* at(std::string_view path) const;
};

/// The file's head as the metadata, its prims as the children. Throws std::runtime_error that names
/// the line where the text is not what it should be.
[[nodiscard]] UsdaPrim read_usda(std::string_view text);

}  // namespace carom::testing
