#include "pipeline/config/reference.h"

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "pipeline/config/sections/sections.h"

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

TEST(Reference, Page_IsWhatTheTableOfKeysSays) {
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
    for (const config::KeyGroup& group : map.groups) {
        for (const std::string& key : group.keys) {
            EXPECT_EQ(names.count(key), 1U) << map.name << " groups an unknown key " << key;
        }
    }
}

TEST(KeyTable, EveryKey_IsUniqueAndDescribed) {
    std::set<const config::MapInfo*> seen;
    check_map(config::shot_spec().info(), seen);
    EXPECT_GT(seen.size(), 30U);
}

}  // namespace
}  // namespace carom::pipeline
