#include "pipeline/config/reference.h"

#include <algorithm>
#include <vector>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/config/reference_examples.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/show_quantity.h"
#include "pipeline/config/text.h"

namespace carom::pipeline {

using namespace config;

namespace {

constexpr const char* kIntroduction = R"(# The keys of a shot

This page is generated from the table of keys that the program itself reads, and a test compares
the two. Each section has an example. With the line `carom: 1` before it, each example is a whole
shot without errors; a test loads them all.

- *Units.* A number may have a unit: `57.15 mm`, `30 deg`, `1/48 s`, `20 km/h`, `6 oz`. Units can
  be multiplied and divided (`kg/m^3`, `N m`). A number without a unit is in SI units. Angles,
  angular velocities, densities, pressures and the lengths of a camera's lens need a unit unless
  they are 0, because readers would assume different units: the tables say "with unit". Levels in
  `dB` and `LUFS` always need it, because 0 dB changes nothing and a factor of 0 would be silence.
- *Exact numbers.* Fractions and decimals of times and rates are kept exactly.
- *Colours* are linear red, green and blue, or one number for grey, or `"#1a6b3c"` (sRGB-encoded).
- *Ranges* are in brackets after the type. A round bracket excludes the end itself.
- *Removing a key.* `null` removes a key of an included file.
- *Quotes.* A text in quotes may continue on further lines only if these are indented more deeply
  than its key. A quote that is not closed is an error.

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
    return enumerate(words, "or");
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
    const std::string fewest = fmt::format("{}", type.fewest);
    const std::string most = fmt::format("{}", type.most);
    return "list of " + (fewest == most ? most : fewest + " to " + most) + ": " + element;
}

std::string describe_alternatives(const TypeInfo& type) {
    if (type.noun == "changing") {
        return describe_type(type.elements.at(0)) + "; a list of two, [start, end]; " +
               describe_type(type.elements.at(3)) + "; or " + describe_type(type.elements.at(2));
    }
    return type.noun.empty() ? describe_elements(type.elements) : with_range(type.noun, type);
}

std::string describe_type(const TypeInfo& type) {
    std::string text;
    switch (type.kind) {
        case TypeInfo::Kind::map:
            return anchor(*type.map);
        case TypeInfo::Kind::named:
            return "map from names to " + describe_type(type.elements.at(0));
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
        case TypeInfo::Kind::text:
            for (const std::string& word : type.choices) {
                text += "`" + word + "`, ";
            }
            return text.empty() ? describe(type)
                                : text + "or another word of `" + type.more_choices + "`";
        case TypeInfo::Kind::settings:
        case TypeInfo::Kind::boolean:
        case TypeInfo::Kind::name:
        case TypeInfo::Kind::file:
            break;
    }
    return describe(type);
}

/// The text of a table cell, with its bars escaped.
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
        return "required";
    }
    if (key.is_needed_there) {
        return "required with `" + join(key.goes_with, "`, `") + "`";
    }
    return key.default_text.empty() ? "" : "`" + key.default_text + "`";
}

std::string describe_groups(const MapInfo& map) {
    std::string text;
    for (const KeyGroup& group : map.groups) {
        std::vector<std::string> words;
        for (const std::string& key : group.keys) {
            words.push_back("`" + key + "`");
        }
        const bool is_needed = group.rule != KeyGroup::Rule::at_most_one;
        const bool is_solved = group.rule == KeyGroup::Rule::exactly_one_or_solved;
        text += std::string("\n") + (is_needed ? "Exactly" : "At most") + " one of " +
                enumerate(words, "and") + (is_solved ? ", or none if `solve` finds it" : "") +
                ".\n";
    }
    return text;
}

std::string describe_map(const MapInfo& map) {
    std::string text = "## " + map.name + "\n\n" + map.description + "\n\n```yaml\n" +
                       reference_examples().at(map.name) + "```\n\n";
    text += "| key | type | default | meaning |\n|---|---|---|---|\n";
    for (const KeyInfo& key : map.keys) {
        text += "| `" + key.name + "` | " + cell(describe_type(key.type)) + " | " +
                cell(describe_default(key)) + " | " + cell(key.description) + " |\n";
    }
    return text + describe_groups(map) + "\n";
}

/// A section of the page, and its depth in the table of contents.
struct Section {
    const MapInfo* map = nullptr;
    std::size_t depth = 0;
};

/// Collects the maps of a type, each once, in the order of their first use.
void collect(const TypeInfo& type, std::size_t depth, std::vector<Section>& sections) {
    const auto is_same = [&](const Section& section) { return section.map == type.map; };
    if (type.map != nullptr && std::ranges::none_of(sections, is_same)) {
        sections.push_back({type.map, depth});
        for (const KeyInfo& key : type.map->keys) {
            collect(key.type, depth + 1, sections);
        }
    }
    for (const TypeInfo& element : type.elements) {
        collect(element, depth, sections);
    }
}

std::string table_of_contents(const std::vector<Section>& sections) {
    std::string text = "## Contents\n\n";
    for (const Section& section : sections) {
        text += std::string(2 * section.depth, ' ') + "- " + anchor(*section.map) + "\n";
    }
    return text + "\n";
}

}  // namespace

std::string reference_markdown() {
    TypeInfo top;
    top.kind = TypeInfo::Kind::map;
    top.map = &shot_spec().info();
    std::vector<Section> sections;
    collect(top, 0, sections);
    std::string text = kIntroduction + table_of_contents(sections);
    for (const Section& section : sections) {
        text += describe_map(*section.map);
    }
    text.pop_back();  // one line end closes the file
    return text;
}

}  // namespace carom::pipeline
