#include "pipeline/config/map_spec.h"

#include <algorithm>
#include <set>

#include "core/text.h"
#include "pipeline/config/key_conditions.h"
#include "pipeline/config/show_quantity.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

constexpr std::size_t kMostListedKeys = 12;

/// What was probably meant by a text that only looks like a key; empty if unknown.
std::string explain_odd_key(const Entry& entry) {
    if (entry.key == "<<") {
        return " (carom has no merge keys; an alias stands for a whole value, and 'include' "
               "merges files)";
    }
    const bool is_number = !entry.key.empty() && entry.key[0] >= '0' && entry.key[0] <= '9';
    if (is_number && entry.value.is_null()) {
        return " (a comma ends the value before it; decimals are written with a point, as in 3.5)";
    }
    return {};
}

/// Reports an unknown key. Returns the key that was probably meant.
std::optional<std::string> report_unknown(Reader& reader, const Entry& entry, const MapInfo& info) {
    for (const auto& [name, reason] : info.refused) {
        if (entry.key == name) {
            reader.error(entry.key_place,
                         quote(entry.key) + " in " + reader.label() + " " + reason);
            return std::nullopt;
        }
    }
    const std::vector<std::string> known = info.key_names();
    Message help = explain_odd_key(entry);
    if (help.text.empty()) {
        help = hint(entry.key, known);
    }
    if (help.text.empty() && known.size() <= kMostListedKeys) {
        help = known.size() == 1 ? " (the only key is " + known[0] + ")"
                                 : " (the keys are " + enumerate(known, "and") + ")";
    }
    reader.error(entry.key_place,
                 "unknown key " + quote(entry.key) + " in " + reader.label() + help);
    return nearest_name(entry.key, known);
}

void report_contradiction(Reader& reader, const Entry& first, const Entry& second) {
    std::string message = "'" + second.key + "' contradicts '" + first.key + "' in " +
                          reader.label() + "; give only one of them";
    if (first.key_place.source != second.key_place.source) {
        message += " (the other comes from " + reader.sources().to_string(first.key_place) + "; '" +
                   first.key + ": null' removes it)";
    }
    reader.error(second.key_place, message);
}

/// A key as it must be written, with its value if only one is possible.
std::string spell(const KeyInfo& key) {
    const Range& range = key.type.range;
    if (key.type.kind == TypeInfo::Kind::integer && range.low && range.low == range.high) {
        return "'" + key.name + ": " + show(*range.low) + "'";
    }
    return "'" + key.name + "'";
}

void check_group(Reader& reader, const Node& node, const KeyGroup& group, bool may_lack) {
    std::vector<const Entry*> given;
    for (const Entry& entry : node.entries) {
        if (std::find(group.keys.begin(), group.keys.end(), entry.key) != group.keys.end()) {
            given.push_back(&entry);
        }
    }
    if (given.empty() && may_lack && group.rule != KeyGroup::Rule::at_most_one) {
        reader.error(reader.key_place(), reader.label() + " needs " +
                                             (group.keys.size() > 2 ? "one of " : "either ") +
                                             enumerate(quoted(group.keys), "or"));
    }
    for (std::size_t i = 1; i < given.size(); ++i) {
        report_contradiction(reader, *given[0], *given[i]);
    }
}

/// Reports unknown entries of `node`, missing required keys and violated groups.
void check_keys(Reader& reader, const Node& node, const MapInfo& info) {
    std::set<std::string> meant;  // by misspelt keys, which are not also reported as missing
    bool has_unknown = false;
    for (const Entry& entry : node.entries) {
        const bool is_known =
            std::any_of(info.keys.begin(), info.keys.end(),
                        [&](const KeyInfo& key) { return key.name == entry.key; });
        if (!is_known) {
            has_unknown = true;
            if (const auto nearest = report_unknown(reader, entry, info)) {
                meant.insert(*nearest);
            }
        }
    }
    for (const KeyInfo& key : info.keys) {
        if (key.is_required && !reader.is_partial() && node.find(key.name) == nullptr &&
            meant.count(key.name) == 0) {
            reader.error(reader.key_place(), reader.label() + " needs the key " + spell(key));
        }
    }
    for (const KeyGroup& group : info.groups) {
        check_group(reader, node, group, !has_unknown && !reader.is_partial());
    }
}

}  // namespace

std::vector<std::string> MapInfo::key_names() const {
    std::vector<std::string> names;
    for (const KeyInfo& key : keys) {
        names.push_back(key.name);
    }
    return names;
}

KeyTable::KeyTable(std::string_view name, std::string_view description) {
    info_.name = name;
    info_.description = description;
}

KeyTable::KeyTable(const KeyTable&) = default;
KeyTable::KeyTable(KeyTable&&) noexcept = default;
KeyTable::~KeyTable() = default;

void KeyTable::add(std::string_view name, const TypeInfo& type, std::string_view default_text,
                   std::string_view description, Step read) {
    info_.keys.push_back(
        {std::string(name), type, std::string(default_text), std::string(description)});
    steps_.push_back(std::move(read));
}

void KeyTable::add_field(std::string_view name, const TypeInfo& type, std::string_view default_text,
                         std::string_view description, ReadFunction read, std::ptrdiff_t offset) {
    add(name, type, default_text, description,
        [read = std::move(read), offset](Reader& reader, const Node& node, void* target) {
            read(reader, node, static_cast<char*>(target) + offset);
        });
}

void KeyTable::add_map(std::string_view name, const MapInfo& map, std::string_view description,
                       Step read) {
    TypeInfo type;
    type.kind = TypeInfo::Kind::map;
    type.map = &map;
    add(name, type, {}, description, std::move(read));
    info_.keys.back().is_always_there = true;
}

void KeyTable::keep_last() {
    info_.keys.back().is_always_there = true;
}

void KeyTable::require_last() {
    info_.keys.back().is_required = true;
    info_.keys.back().default_text.clear();
}

void KeyTable::pair_last(std::vector<std::string> partners, bool is_needed) {
    info_.keys.back().goes_with = std::move(partners);
    info_.keys.back().is_needed_there = is_needed;
    if (is_needed) {
        info_.keys.back().default_text.clear();
    }
}

void KeyTable::exclude_last(Exclusion exclusion) {
    info_.keys.back().exclusions.push_back(std::move(exclusion));
}

void KeyTable::add_group(KeyGroup::Rule rule, std::vector<std::string> keys) {
    info_.groups.push_back({rule, std::move(keys)});
}

void KeyTable::set_kinds(std::vector<std::string> keys) {
    info_.kinds = std::move(keys);
}

void KeyTable::refuse(std::string_view name, std::string_view reason) {
    info_.refused.emplace_back(name, reason);
}

void KeyTable::add_check(Step check) {
    checks_.push_back(std::move(check));
}

void KeyTable::read(Reader& reader, const Node& node, void* target) const {
    if (!node.is_map()) {
        reader.wrong_type(node, "a map of keys");
        return;
    }
    check_keys(reader, node, info_);
    for (std::size_t i = 0; i < info_.keys.size(); ++i) {
        if (const Entry* entry = node.find(info_.keys[i].name)) {
            const Reader::Scope scope(reader, entry->key, entry->key_place);
            if (entry->value.is_null()) {
                reader.error(entry->key_place, reader.value_name() + " has no value");
                continue;
            }
            steps_[i](reader, entry->value, target);
        }
    }
    check_conditions(reader, node, info_);
    for (const Step& check : checks_) {
        check(reader, node, target);
    }
}

}  // namespace carom::pipeline::config
