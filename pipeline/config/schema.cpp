#include "pipeline/config/schema.h"

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "core/json_text.h"
#include "core/text.h"
#include "pipeline/config/quantity_schema.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/show_quantity.h"
#include "pipeline/config/text.h"

namespace carom::pipeline {

using namespace config;

namespace {

// ---- JSON -----------------------------------------------------------------------------------

using Members = std::vector<std::pair<std::string, std::string>>;  // name, JSON

std::string object(const Members& members) {
    std::vector<std::string> items;
    items.reserve(members.size());
    for (const auto& [name, value] : members) {
        items.push_back(json_string(name) + ": " + value);
    }
    return "{" + join(items, ", ") + "}";
}

std::string array(const std::vector<std::string>& items) {
    return "[" + join(items, ", ") + "]";
}

std::string quoted_array(const std::vector<std::string>& words) {
    std::vector<std::string> items;
    items.reserve(words.size());
    for (const std::string& word : words) {
        items.push_back(json_string(word));
    }
    return array(items);
}

std::string any_of(const std::vector<std::string>& alternatives) {
    return alternatives.size() == 1 ? alternatives[0] : object({{"anyOf", array(alternatives)}});
}

// ---- scalars --------------------------------------------------------------------------------

/// A plain number within the range, or only 0 if other numbers need a unit. Empty if no plain
/// number is allowed.
std::string plain_number_schema(const TypeInfo& type) {
    if (!type.needed_unit.empty()) {
        const bool takes_zero = type.range.contains(0) && !info(type.dimension).is_logarithmic;
        return takes_zero ? object({{"const", "0"}}) : std::string();
    }
    Members number{{"type", json_string("number")}};
    if (type.range.low) {
        number.emplace_back(type.range.low_open ? "exclusiveMinimum" : "minimum",
                            show(*type.range.low));
    }
    if (type.range.high) {
        number.emplace_back(type.range.high_open ? "exclusiveMaximum" : "maximum",
                            show(*type.range.high));
    }
    return object(number);
}

std::string text_of(const std::string& pattern, const Members& more = {}) {
    Members members{{"type", json_string("string")}, {"pattern", json_string(pattern)}};
    members.insert(members.end(), more.begin(), more.end());
    return object(members);
}

/// For editors: the unit of displayed values, the usual units, and whether a number needs one.
Members unit_members(const TypeInfo& type) {
    const DimensionInfo& dimension = info(type.dimension);
    if (dimension.units.empty()) {
        return {};
    }
    const std::string unit = type.needed_unit.empty() ? dimension.unit : type.needed_unit;
    Members members{{"x-unit", json_string(unit)}, {"x-units", json_string(dimension.units)}};
    if (!type.needed_unit.empty()) {
        members.emplace_back("x-needs-unit", "true");
    }
    if (dimension.is_logarithmic) {
        members.emplace_back("x-zero-needs-unit", "true");
    }
    return members;
}

std::string integer_schema(const TypeInfo& type) {
    Members integer{{"type", json_string("integer")}};
    // JSON numbers above 2^53 are not exact.
    if (type.range.low && *type.range.low > -9e15) {
        integer.emplace_back("minimum", show(*type.range.low));
    }
    if (type.range.high && *type.range.high < 9e15) {
        integer.emplace_back("maximum", show(*type.range.high));
    }
    return any_of({object(integer), object({{"type", json_string("string")},
                                            {"pattern", json_string("^-?[0-9]+$")}})});
}

std::string text_schema(const TypeInfo& type) {
    if (!type.pattern.empty()) {
        return text_of(type.pattern);
    }
    // YAML may read a word as a number.
    Members word{
        {"type", array({json_string("string"), json_string("number"), json_string("boolean")})}};
    if (!type.more_choices.empty()) {
        word.emplace_back("x-keys-of", json_string(type.more_choices));
    }
    const std::string any = object(word);
    return type.choices.empty()
               ? any
               : any_of({object({{"enum", quoted_array(type.choices)}}), any});  // for suggestions
}

std::string choice_schema(const TypeInfo& type) {
    std::vector<std::string> values;
    for (const std::string& word : type.choices) {
        values.push_back(json_string(word));
        double number = 0;
        const char* const end = word.data() + word.size();
        const auto [stop, code] = std::from_chars(word.data(), end, number);
        if ((code == std::errc() && stop == end) || word == "true" || word == "false") {
            values.push_back(word);  // the value that YAML reads without quotes
        }
    }
    return object({{"enum", array(values)}});
}

// ---- the whole ------------------------------------------------------------------------------

/// Members whose names begin with "x-" are for editors; other readers of schemas skip them.
///
/// Generates the definitions of maps in the order of their first use. A map that may be merged with
/// an included one need not be complete. A map in a list is not merged, so it must be.
class Schema {
  public:
    std::string text() {
        std::string json =
            "{\n  \"$schema\": \"http://json-schema.org/draft-07/schema#\",\n"
            "  \"title\": \"a shot of carom\",\n"
            "  \"allOf\": [{\"$ref\": " +
            json_string(reference(shot_spec().info(), false)) + "}],\n  \"definitions\": {\n";
        while (described_ < maps_.size()) {
            const Known known = maps_[described_];
            const std::string definition = describe_map(*known.map, known.is_whole);
            json += (described_ > 0 ? ",\n" : "") + ("    " + json_string(known.name)) + ": " +
                    definition;
            ++described_;
        }
        for (const Shared& shared : shared_) {
            json += ",\n    " + json_string(shared.name) + ": " + shared.definition;
        }
        return json + "\n  }\n}\n";
    }

  private:
    struct Known {
        const MapInfo* map = nullptr;
        bool is_whole = false;
        std::string name;
    };

    /// A definition that many keys have in common.
    struct Shared {
        std::string name;
        std::string definition;
    };

    /// A reference to the shared `definition`, whose name begins with `noun` ("a length").
    std::string shared(std::string noun, const std::string& definition) {
        std::replace(noun.begin(), noun.end(), ' ', '-');
        int of_this_noun = 1;
        for (const Shared& known : shared_) {
            if (known.definition == definition) {
                return object({{"$ref", json_string("#/definitions/" + known.name)}});
            }
            of_this_noun += known.name.starts_with(noun + "-text-") ? 1 : 0;
        }
        shared_.push_back({fmt::format("{}-text-{}", noun, of_this_noun), definition});
        return object({{"$ref", json_string("#/definitions/" + shared_.back().name)}});
    }

    std::string quantity_schema(const TypeInfo& type) {
        const std::string& noun = info(type.dimension).name;
        std::string text =
            shared(noun, text_of(dimension_pattern(type.dimension, !type.needed_unit.empty()),
                                 unit_members(type)));
        if (type.range.low || type.range.high) {
            text = object({{"allOf", array({text, shared(noun, text_of(range_pattern(type)))})},
                           {"x-range", json_string(describe(type.range, type.dimension))}});
        }
        const std::string number = plain_number_schema(type);
        return number.empty() ? text : any_of({number, text});
    }

    std::string reference(const MapInfo& map, bool is_whole) {
        const auto known = std::find_if(maps_.begin(), maps_.end(), [&](const Known& k) {
            return k.map == &map && k.is_whole == is_whole;
        });
        if (known != maps_.end()) {
            return "#/definitions/" + known->name;
        }
        std::string name = map.name + (is_whole ? "" : " (merged)");
        std::replace(name.begin(), name.end(), ' ', '-');
        const auto is_taken = [&](const std::string& wanted) {
            return std::any_of(maps_.begin(), maps_.end(),
                               [&](const Known& k) { return k.name == wanted; });
        };
        std::string unique = name;
        for (int i = 2; is_taken(unique); ++i) {
            unique = fmt::format("{}-{}", name, i);
        }
        maps_.push_back({&map, is_whole, unique});
        return "#/definitions/" + unique;
    }

    std::string schema_of(const TypeInfo& type, bool is_whole) {
        switch (type.kind) {
            case TypeInfo::Kind::boolean:
                return object({{"type", json_string("boolean")}});
            case TypeInfo::Kind::integer:
                return integer_schema(type);
            case TypeInfo::Kind::quantity:
                return quantity_schema(type);
            case TypeInfo::Kind::text:
                return text_schema(type);
            case TypeInfo::Kind::name:
                return object(
                    {{"type", json_string("string")}, {"x-name-of", json_string(type.noun)}});
            case TypeInfo::Kind::file:
                return object({{"type", json_string("string")}, {"x-file", "true"}});
            case TypeInfo::Kind::choice:
                return choice_schema(type);
            case TypeInfo::Kind::list:
                return list_schema(type);
            case TypeInfo::Kind::named:
                return object(
                    {{"type", json_string("object")},
                     {"propertyNames",
                      object({{"pattern", json_string("^[A-Za-z_][A-Za-z0-9_-]{0,63}$")}})},
                     {"additionalProperties", any_of({schema_of(type.elements.at(0), is_whole),
                                                      object({{"type", json_string("null")}})})}});
            case TypeInfo::Kind::settings:
                return object({{"type", json_string("object")}});
            case TypeInfo::Kind::map:
                if (is_whole && may_include(*type.map)) {
                    const std::string with_include =
                        array({object({{"required", quoted_array({"include"})}}),
                               object({{"$ref", json_string(reference(*type.map, false))}})});
                    return any_of({object({{"$ref", json_string(reference(*type.map, true))}}),
                                   object({{"allOf", with_include}})});
                }
                return object({{"$ref", json_string(reference(*type.map, is_whole))}});
            case TypeInfo::Kind::any_of: {
                std::vector<std::string> alternatives;
                for (const TypeInfo& element : type.elements) {
                    alternatives.push_back(schema_of(element, is_whole));
                }
                return any_of(alternatives);
            }
        }
        return "{}";
    }

    /// Whether a map in a list may include a file.
    static bool may_include(const MapInfo& map) {
        return std::any_of(map.keys.begin(), map.keys.end(),
                           [](const KeyInfo& key) { return key.name == "include"; });
    }

    std::string list_schema(const TypeInfo& type) {
        Members list{{"type", json_string("array")},
                     {"items", schema_of(type.elements.at(0), true)}};
        if (type.fewest > 0) {
            list.emplace_back("minItems", fmt::format("{}", type.fewest));
        }
        if (type.most >= 0) {
            list.emplace_back("maxItems", fmt::format("{}", type.most));
        }
        return object(list);
    }

    /// `has_kinds`: one of the keys of the map decides which others it may have. Otherwise a key
    /// may have a meaning beside one of some others only.
    std::string property(const KeyInfo& key, bool is_whole, bool has_kinds) {
        std::vector<std::string> alternatives{schema_of(key.type, is_whole)};
        if (!is_whole) {  // null removes the key of an included file
            alternatives.push_back(object({{"type", json_string("null")}}));
        }
        Members members{{"description", json_string(key.description)}};
        if (!key.default_text.empty()) {
            members[0].second =
                json_string(key.description + " (default: " + key.default_text + ")");
        }
        members.emplace_back("anyOf", array(alternatives));
        if (!key.goes_with.empty()) {
            members.emplace_back(has_kinds ? "x-goes-with" : "x-only-with",
                                 quoted_array(key.goes_with));
        }
        return object(members);
    }

    std::string describe_map(const MapInfo& map, bool is_whole) {
        std::string properties;
        std::vector<std::string> required;
        for (const KeyInfo& key : map.keys) {
            properties +=
                (properties.empty() ? "\n" : ",\n") + ("        " + json_string(key.name) + ": " +
                                                       property(key, is_whole, !map.kinds.empty()));
            if (key.is_required && is_whole) {
                required.push_back(key.name);
            }
        }
        const bool is_root = &map == &shot_spec().info();
        if (is_root) {
            required.emplace_back("carom");
        }
        std::string json = "{\n      \"description\": " + json_string(map.description) +
                           ",\n      \"type\": \"object\",\n      \"additionalProperties\": " +
                           "false,\n      \"properties\": {" + properties + "\n      }";
        if (!required.empty()) {
            json += ",\n      \"required\": " + quoted_array(required);
        }
        const std::vector<std::string> rules = rules_of(map, is_whole);
        if (!rules.empty()) {
            json += ",\n      \"allOf\": " + array(rules);
        }
        return json + "\n    }";
    }

    /// Refuses two keys beside each other. In a map that may be merged, a key that is null takes
    /// that of an included file away and so contradicts none.
    static std::string contradiction(const std::string& a, const std::string& b, bool is_whole) {
        Members both{{"required", quoted_array({a, b})}};
        if (!is_whole) {
            const std::string given = object({{"not", object({{"type", json_string("null")}})}});
            both.emplace_back("patternProperties",
                              object({{fmt::format("^({}|{})$", a, b), given}}));
        }
        return object({{"not", object(both)}});
    }

    static std::vector<std::string> rules_of(const MapInfo& map, bool is_whole) {
        std::vector<std::string> rules;
        for (const KeyGroup& group : map.groups) {
            std::vector<std::string> present;
            for (std::size_t i = 0; i < group.keys.size(); ++i) {
                present.push_back(object({{"required", quoted_array({group.keys[i]})}}));
                for (std::size_t j = 0; j < i; ++j) {
                    rules.push_back(contradiction(group.keys[j], group.keys[i], is_whole));
                }
            }
            if (is_whole && group.rule == KeyGroup::Rule::exactly_one) {
                rules.push_back(any_of(present));
            }
        }
        return rules;
    }

    std::vector<Known> maps_;
    std::vector<Shared> shared_;
    std::size_t described_ = 0;
};

}  // namespace

std::string schema_json() {
    return Schema().text();
}

}  // namespace carom::pipeline
