#include "pipeline/config/changed_keys.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include <fmt/core.h>

#include "pipeline/config/parse_yaml.h"

namespace carom::pipeline {

using namespace config;

namespace {

constexpr std::array<std::string_view, 9> kSections{
    "simulation", "physics", "ball_set", "table", "rack", "balls", "objects", "events", "respot"};

// The keys of balls and objects that are not compared.
constexpr std::array<std::string_view, 3> kLook{"look", "material", "smooth"};

Node parse(const std::string& text) {
    SourceSet sources;
    ProblemList problems(sources);
    const int source = sources.add({"shot", ".", text});
    return parse_yaml(sources, source, problems).value_or(Node{});
}

void compare(const Node& before, const Node& after, const std::string& path,
             std::vector<std::string>& changed);

void compare_maps(const Node& before, const Node& after, const std::string& path,
                  std::vector<std::string>& changed) {
    const Node nothing;
    const auto child = [&](const std::string& key) {
        return path.empty() ? key : path + "." + key;
    };
    for (const Entry& entry : after.entries) {
        const Entry* old = before.find(entry.key);
        compare(old != nullptr ? old->value : nothing, entry.value, child(entry.key), changed);
    }
    for (const Entry& entry : before.entries) {
        if (after.find(entry.key) == nullptr) {
            changed.push_back(child(entry.key));
        }
    }
}

void compare(const Node& before, const Node& after, const std::string& path,
             std::vector<std::string>& changed) {
    if (before.is_map() && after.is_map()) {
        compare_maps(before, after, path, changed);
    } else if (before.is_sequence() && after.is_sequence() &&
               before.items.size() == after.items.size()) {
        for (std::size_t i = 0; i < after.items.size(); ++i) {
            compare(before.items[i], after.items[i], fmt::format("{}[{}]", path, i), changed);
        }
    } else if (before.kind != after.kind || before.text != after.text ||
               before.items.size() != after.items.size()) {
        changed.push_back(path);
    }
}

/// Removes the keys of balls and objects that are not compared.
void remove_look(Node& root) {
    for (const std::string_view section : {"balls", "objects"}) {
        Entry* entries = root.find(section);
        if (entries == nullptr) {
            continue;
        }
        for (Entry& named : entries->value.entries) {
            // Without physics an object that keys move is only visible.
            const bool is_only_visible = named.value.find("physics") == nullptr;
            std::erase_if(named.value.entries, [&](const Entry& entry) {
                return std::find(kLook.begin(), kLook.end(), entry.key) != kLook.end() ||
                       (is_only_visible && entry.key == "motion");
            });
        }
    }
}

/// The sections that affect the simulation.
Node physics_of(const std::string& text) {
    Node root = parse(text);
    std::erase_if(root.entries, [](const Entry& entry) { return !is_physics_section(entry.key); });
    remove_look(root);
    return root;
}

}  // namespace

bool is_physics_section(std::string_view section) {
    return std::find(kSections.begin(), kSections.end(), section) != kSections.end();
}

std::vector<std::string> changed_physics_keys(const std::string& before, const std::string& after) {
    std::vector<std::string> changed;
    compare_maps(physics_of(before), physics_of(after), "", changed);
    return changed;
}

}  // namespace carom::pipeline
