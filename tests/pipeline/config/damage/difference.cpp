#include "tests/pipeline/config/damage/difference.h"

#include <algorithm>

#include "pipeline/config/quantity.h"
#include "pipeline/config/shot_source.h"
#include "tests/pipeline/config/shot_text.h"

namespace carom::testing {

namespace {

using pipeline::config::Entry;
using pipeline::config::Node;
using pipeline::config::Quantity;

bool is_same_scalar(const Node& a, const Node& b) {
    if (a.text == b.text) {
        return true;
    }
    const auto first = pipeline::config::parse_quantity(a.text);
    const auto second = pipeline::config::parse_quantity(b.text);
    const auto* x = std::get_if<Quantity>(&first);
    const auto* y = std::get_if<Quantity>(&second);
    return x != nullptr && y != nullptr && x->value == y->value;
}

std::vector<Difference> differences_between(const Node& before, const Node& after);

/// Adds the difference of two maps that differ only in the name of one key; false otherwise.
bool add_renaming(const Node& before, const Node& after, const std::string& path,
                  std::vector<Difference>& found) {
    const Entry* old_entry = nullptr;
    const Entry* new_entry = nullptr;
    for (std::size_t i = 0; i < std::min(before.entries.size(), after.entries.size()); ++i) {
        if (before.entries[i].key == after.entries[i].key) {
            continue;
        }
        if (old_entry != nullptr) {
            return false;
        }
        old_entry = &before.entries[i];
        new_entry = &after.entries[i];
    }
    if (old_entry == nullptr || before.entries.size() != after.entries.size() ||
        !differences_between(old_entry->value, new_entry->value).empty()) {
        return false;
    }
    found.push_back({path, old_entry->key, new_entry->key, false, true});
    return true;
}

void compare(const Node& before, const Node& after, const std::string& path,
             std::vector<Difference>& found) {
    if (before.kind != after.kind || before.items.size() != after.items.size()) {
        found.push_back({path, before.text, after.text, false});
        return;
    }
    if (before.is_scalar() && !is_same_scalar(before, after)) {
        found.push_back({path, before.text, after.text, true});
    }
    for (std::size_t i = 0; i < before.items.size(); ++i) {
        compare(before.items[i], after.items[i], path + "[" + std::to_string(i) + "]", found);
    }
    const bool is_renamed = add_renaming(before, after, path, found);
    for (const Entry& entry : before.entries) {
        const Entry* other = after.find(entry.key);
        const std::string key = path + (path.empty() ? "" : ".") + entry.key;
        if (other == nullptr && !is_renamed) {
            found.push_back({key, entry.key, "", false});
        } else if (other != nullptr) {
            compare(entry.value, other->value, key, found);
        }
    }
    for (const Entry& entry : after.entries) {
        if (before.find(entry.key) == nullptr && !is_renamed) {
            found.push_back({path + (path.empty() ? "" : ".") + entry.key, "", entry.key, false});
        }
    }
}

std::vector<Difference> differences_between(const Node& before, const Node& after) {
    std::vector<Difference> found;
    compare(before, after, "", found);
    return found;
}

}  // namespace

std::vector<Difference> differences(const pipeline::LoadResult& before,
                                    const pipeline::LoadResult& after) {
    std::vector<Difference> found =
        differences_between(before.source->root(), after.source->root());
    if (found.empty() && pipeline::shot_text(*before.shot) != pipeline::shot_text(*after.shot)) {
        found.push_back({"the shot made of the same tree", "", "", false});
    }
    return found;
}

}  // namespace carom::testing
