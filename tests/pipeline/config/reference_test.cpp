#include "pipeline/config/reference.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/reference_examples.h"
#include "pipeline/config/sections/sections.h"
#include "tests/folders.h"
#include "tests/pipeline/config/load.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

/// The first line in which two texts differ.
std::string first_difference(const std::string& a, const std::string& b) {
    std::istringstream left(a);
    std::istringstream right(b);
    std::string left_line;
    std::string right_line;
    while (std::getline(left, left_line) && std::getline(right, right_line)) {
        if (left_line != right_line) {
            break;
        }
    }
    return "'" + left_line + "' against '" + right_line + "'";
}

TEST(Reference, Page_MatchesTheTableOfKeys) {
    const std::string path = std::string(CAROM_SOURCE_DIR) + "/docs/reference.md";
    std::ifstream stream(path, std::ios::binary);
    const std::string page{std::istreambuf_iterator<char>(stream), {}};
    const std::string made = reference_markdown();
    if (page != made) {
        std::ofstream(std::string(CAROM_BINARY_DIR) + "/reference.md") << made;
    }
    EXPECT_TRUE(page == made) << "docs/reference.md is not up to date: "
                              << first_difference(page, made)
                              << "; copy reference.md from the build folder over it";
}

/// The keys on which others depend.
std::vector<std::string> named_in_conditions(const config::MapInfo& map) {
    std::vector<std::string> keys = map.kinds;
    for (const config::KeyGroup& group : map.groups) {
        keys.insert(keys.end(), group.keys.begin(), group.keys.end());
    }
    for (const config::KeyInfo& key : map.keys) {
        keys.insert(keys.end(), key.goes_with.begin(), key.goes_with.end());
        for (const config::Exclusion& exclusion : key.exclusions) {
            keys.push_back(exclusion.by);
            if (!exclusion.unless.empty()) {
                keys.push_back(exclusion.unless);
            }
        }
    }
    return keys;
}

void check_map(const config::MapInfo& map, std::set<const config::MapInfo*>& seen) {
    if (!seen.insert(&map).second) {
        return;
    }
    std::set<std::string> names;
    for (const config::KeyInfo& key : map.keys) {
        EXPECT_TRUE(names.insert(key.name).second) << map.name << " has '" << key.name << "' twice";
        EXPECT_FALSE(key.description.empty()) << map.name << "." << key.name;
        std::vector<config::TypeInfo> types{key.type};
        while (!types.empty()) {
            const config::TypeInfo type = types.back();
            types.pop_back();
            types.insert(types.end(), type.elements.begin(), type.elements.end());
            if (type.map != nullptr) {
                check_map(*type.map, seen);
            }
        }
    }
    for (const std::string& key : named_in_conditions(map)) {
        EXPECT_EQ(names.count(key), 1U) << map.name << " has a condition on an unknown key " << key;
    }
}

TEST(KeyTable, EveryKey_IsUniqueAndDescribed) {
    std::set<const config::MapInfo*> seen;
    check_map(config::shot_spec().info(), seen);
    EXPECT_GT(seen.size(), 30U);
}

void add_sections_of(const config::Node& node, const config::TypeInfo& type,
                     std::set<std::string>& names);

void add_section(const config::Node& node, const config::MapInfo& map,
                 std::set<std::string>& names) {
    const auto knows = [&](const config::Entry& entry) {
        return std::ranges::any_of(
            map.keys, [&](const config::KeyInfo& key) { return key.name == entry.key; });
    };
    if (!node.is_map() || !std::ranges::all_of(node.entries, knows)) {
        return;
    }
    names.insert(map.name);
    for (const config::KeyInfo& key : map.keys) {
        if (const config::Entry* entry = node.find(key.name)) {
            add_sections_of(entry->value, key.type, names);
        }
    }
}

/// The sections of the reference that a value of this type uses.
void add_sections_of(const config::Node& node, const config::TypeInfo& type,
                     std::set<std::string>& names) {
    if (type.map != nullptr) {
        add_section(node, *type.map, names);
    }
    for (const config::TypeInfo& element : type.elements) {
        if (type.kind == config::TypeInfo::Kind::any_of) {
            add_sections_of(node, element, names);
            continue;
        }
        for (const config::Node& item : node.items) {
            add_sections_of(item, element, names);
        }
        for (const config::Entry& entry : node.entries) {
            add_sections_of(entry.value, element, names);
        }
    }
}

std::set<std::string> sections_used_by(const std::string& yaml) {
    config::SourceSet sources;
    config::ProblemList problems(sources);
    const int source = sources.add({.name = "example.yaml", .folder = "", .text = yaml});
    const auto node = config::parse_yaml(sources, source, problems);
    std::set<std::string> names;
    if (node) {
        add_section(*node, config::shot_spec().info(), names);
    }
    return names;
}

TEST(Reference, EverySection_HasAnExample) {
    std::set<const config::MapInfo*> maps;
    check_map(config::shot_spec().info(), maps);
    std::set<std::string> sections;
    for (const config::MapInfo* map : maps) {
        EXPECT_TRUE(sections.insert(map->name).second) << "two sections are called " << map->name;
    }
    std::set<std::string> examples;
    for (const auto& [section, yaml] : config::reference_examples()) {
        examples.insert(section);
    }
    EXPECT_EQ(examples, sections);
}

TEST(Reference, Examples_AreValidShotsThatUseTheirSection) {
    const carom::testing::ScratchFolder folder;
    std::ofstream(folder.path("logo.png"));    // for the example with a picture
    std::ofstream(folder.path("piano.flac"));  // and the one with music
    for (const auto& [section, yaml] : config::reference_examples()) {
        SCOPED_TRACE(section);
        const bool has_camera = yaml.find("cameras:") != std::string::npos;
        const LoadResult result = load_shot_text("carom: 1\n" + (has_camera ? "" : kCamera) + yaml,
                                                 folder.path("shot.yaml"));
        if (yaml.starts_with("film:")) {  // sequence_load_test reads such files
            ASSERT_EQ(result.problems.size(), 1U);
            EXPECT_EQ(result.problems[0].message,
                      "this is a film of several shots, where a single shot is needed");
        } else {
            EXPECT_EQ(all_problems(result), "");
            EXPECT_TRUE(result.shot);
        }
        EXPECT_EQ(sections_used_by(yaml).count(section), 1U) << "the example does not use it";
    }
}

}  // namespace
}  // namespace carom::pipeline
