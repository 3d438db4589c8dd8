#include "pipeline/config/reference.h"

#include <algorithm>
#include <vector>

#include "pipeline/config/sections/sections.h"
#include "pipeline/config/show_quantity.h"
#include "pipeline/config/text.h"

namespace carom::pipeline {

using namespace config;

namespace {

constexpr const char* kIntroduction = R"(# The keys of a shot

This page is made from the table of keys that the program itself reads; a test holds them together.

A number may carry a unit: `57.15 mm`, `30 deg`, `1/48 s`, `20 km/h`, `6 oz`; units multiply and
divide (`kg/m^3`, `N m`). A plain number is in SI units. Angles, angular velocities, densities and
the lengths of a camera's lens have no plain numbers except 0, because readers would take them to be
in different units: the tables say "with unit". Fractions and decimals of times and rates are kept
exactly. Colours are linear red, green and blue, one number for grey, or `"#1a6b3c"`
(sRGB-encoded). `null` takes a key of an included file away. In ranges a round bracket leaves the
end itself out. A text in quotes may continue on further lines only if these are indented deeper
than its key; a quote that is not closed is an error.

)";

std::string anchor(const MapInfo& map) {
    std::string text = map.name;
    std::replace(text.begin(), text.end(), ' ', '-');
    return "[" + map.name + "](#" + text + ")";
}

std::string describe_type(const TypeInfo& type);

std::string describe_elements(const std::vector<TypeInfo>& elements) {
    std::vector<std::string> words;
    for (const TypeInfo& element : elements) {
        std::string word = describe_type(element);
        if (std::find(words.begin(), words.end(), word) == words.end()) {
            words.push_back(std::move(word));
        }
    }
    return join(words, "or");
}

/// "(0 s, 3600 s]"
std::string describe_range(const Range& range, Dimension dimension) {
    if (!range.low || !range.high) {
        return describe(range, dimension);
    }
    if (range.low == range.high) {
        return show(*range.low, dimension);
    }
    return (range.low_open ? "(" : "[") + show(*range.low, dimension) + ", " +
           show(*range.high, dimension) + (range.high_open ? ")" : "]");
}

std::string with_range(const std::string& text, const TypeInfo& type) {
    const std::string range = describe_range(type.range, type.dimension);
    return range.empty() ? text : text + " " + range;
}

std::string describe_list(const TypeInfo& type) {
    const std::string element = describe_type(type.elements.at(0));
    if (type.most < 0) {
        return "list: " + element;
    }
    const std::string fewest = std::to_string(type.fewest);
    const std::string most = std::to_string(type.most);
    return "list of " + (fewest == most ? most : fewest + " to " + most) + ": " + element;
}

std::string describe_alternatives(const TypeInfo& type) {
    if (type.noun == "changing") {
        return describe_type(type.elements.at(0)) + "; two of them; or " +
               describe_type(type.elements.at(2));
    }
    return type.noun.empty() ? describe_elements(type.elements) : with_range(type.noun, type);
}

std::string describe_type(const TypeInfo& type) {
    std::string text;
    switch (type.kind) {
        case TypeInfo::Kind::map:
            return anchor(*type.map);
        case TypeInfo::Kind::named:
            return "names, each with " + describe_type(type.elements.at(0));
        case TypeInfo::Kind::any_of:
            return describe_alternatives(type);
        case TypeInfo::Kind::choice:
            for (const std::string& word : type.choices) {
                text += (text.empty() ? "`" : ", `") + word + "`";
            }
            return text;
        case TypeInfo::Kind::list:
            return describe_list(type);
        case TypeInfo::Kind::quantity:
            text = info(type.dimension).name;
            text = type.dimension == Dimension::none ? "number" : text.substr(text.find(' ') + 1);
            return with_range(text + (type.needed_unit.empty() ? "" : " with unit"), type);
        case TypeInfo::Kind::integer:
            return with_range("whole number", type);
        case TypeInfo::Kind::boolean:
        case TypeInfo::Kind::text:
        case TypeInfo::Kind::name:
        case TypeInfo::Kind::file:
            break;
    }
    return describe(type);
}

/// A cell of a table.
std::string cell(std::string text) {
    std::size_t at = 0;
    while ((at = text.find('|', at)) != std::string::npos) {
        text.replace(at, 1, "\\|");
        at += 2;
    }
    return text;
}

std::string describe_default(const KeyInfo& key) {
    if (key.is_required) {
        return "needed";
    }
    return key.default_text.empty() ? "" : "`" + key.default_text + "`";
}

std::string describe_map(const MapInfo& map) {
    std::string text = "## " + map.name + "\n\n" + map.description + "\n\n";
    text += "| key | type | default | meaning |\n|---|---|---|---|\n";
    for (const KeyInfo& key : map.keys) {
        text += "| `" + key.name + "` | " + cell(describe_type(key.type)) + " | " +
                cell(describe_default(key)) + " | " + cell(key.description) + " |\n";
    }
    for (const KeyGroup& group : map.groups) {
        std::vector<std::string> words;
        for (const std::string& key : group.keys) {
            words.push_back("`" + key + "`");
        }
        const bool is_needed = group.rule == KeyGroup::Rule::exactly_one;
        text += std::string("\n") + (is_needed ? "Exactly" : "At most") + " one of " +
                join(words, "and") + ".\n";
    }
    return text + "\n";
}

/// The maps that a type leads to, each once, in the order in which a reader meets them.
void collect(const TypeInfo& type, std::vector<const MapInfo*>& maps) {
    if (type.map != nullptr && std::find(maps.begin(), maps.end(), type.map) == maps.end()) {
        maps.push_back(type.map);
        for (const KeyInfo& key : type.map->keys) {
            collect(key.type, maps);
        }
    }
    for (const TypeInfo& element : type.elements) {
        collect(element, maps);
    }
}

}  // namespace

std::string reference_markdown() {
    TypeInfo top;
    top.kind = TypeInfo::Kind::map;
    top.map = &shot_spec().info();
    std::vector<const MapInfo*> maps;
    collect(top, maps);
    std::string text = kIntroduction;
    for (const MapInfo* map : maps) {
        text += describe_map(*map);
    }
    text.pop_back();  // one line end closes the file
    return text;
}

}  // namespace carom::pipeline
