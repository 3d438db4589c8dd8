#include "pipeline/config/key_conditions.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

bool contains(const std::vector<std::string>& keys, const std::string& key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// The first of `keys` that the map gives, or nullptr.
const Entry* find_any(const Node& map, const std::vector<std::string>& keys) {
    for (const std::string& key : keys) {
        if (const Entry* entry = map.find(key)) {
            return entry;
        }
    }
    return nullptr;
}

/// The reason why `key` has no meaning in the map, as it follows the key in a message; empty if it
/// has one.
std::string why_meaningless(const MapInfo& info, const KeyInfo& key, const Node& map) {
    if (key.goes_with.empty()) {
        return {};
    }
    if (!info.kinds.empty()) {
        const Entry* kind = find_any(map, info.kinds);
        if (kind == nullptr || contains(key.goes_with, kind->key)) {
            return {};
        }
        const bool is_vowel = std::string_view("aeiou").find(kind->key[0]) != std::string::npos;
        return fmt::format("has no meaning for {} {} {}", is_vowel ? "an" : "a", kind->key,
                           info.name);
    }
    return find_any(map, key.goes_with) != nullptr
               ? std::string()
               : "has no meaning without " + enumerate(quoted(key.goes_with), "or");
}

/// The first exclusion that applies to `key` in the map, or nullptr.
const Exclusion* find_exclusion(const KeyInfo& key, const Node& map) {
    const auto excludes = [&](const Exclusion& exclusion) {
        const Entry* by = map.find(exclusion.by);
        const bool is_lifted = !exclusion.unless.empty() && map.find(exclusion.unless) != nullptr;
        return by != nullptr && exclusion.is_excluding(by->value) && !is_lifted;
    };
    const auto found = std::find_if(key.exclusions.begin(), key.exclusions.end(), excludes);
    return found == key.exclusions.end() ? nullptr : &*found;
}

void report_needed(Reader& reader, const KeyInfo& key, const Node& map) {
    const Entry* partner = find_any(map, key.goes_with);
    if (partner != nullptr && map.find(key.name) == nullptr) {
        reader.error(partner->key_place, "'" + partner->key + "' needs the key '" + key.name + "'");
    }
}

}  // namespace

bool can_be_added(const MapInfo& info, const KeyInfo& key, const Node& map) {
    const auto is_taken = [&](const KeyGroup& group) {
        return contains(group.keys, key.name) && find_any(map, group.keys) != nullptr;
    };
    return why_meaningless(info, key, map).empty() && find_exclusion(key, map) == nullptr &&
           std::none_of(info.groups.begin(), info.groups.end(), is_taken);
}

void check_conditions(Reader& reader, const Node& map, const MapInfo& info) {
    for (const KeyInfo& key : info.keys) {
        if (key.is_needed_there) {
            report_needed(reader, key, map);
        }
        const Entry* entry = map.find(key.name);
        if (entry == nullptr) {
            continue;
        }
        if (const std::string problem = why_meaningless(info, key, map); !problem.empty()) {
            reader.error(entry->key_place, "'" + key.name + "' " + problem);
        }
        if (const Exclusion* exclusion = find_exclusion(key, map)) {
            reader.error(entry->key_place,
                         "'" + key.name + "' " +
                             fmt::format(fmt::runtime(exclusion->reason), reader.label()));
        }
    }
}

}  // namespace carom::pipeline::config
