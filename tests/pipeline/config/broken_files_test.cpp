// Compares the problems of each file in tests/broken with its expected output.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "pipeline/config/load_shot.h"
#include "tests/folders.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(CAROM_SOURCE_DIR) / "tests/broken";

std::string read(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> broken_files() {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(kFolder)) {
        if (entry.path().extension() == ".yaml") {
            names.push_back(entry.path().stem().string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// The values of comment lines such as "# --set render.samples=16".
std::vector<std::string> options(const std::string& text, const std::string& option) {
    const std::string start = "# --" + option + " ";
    std::vector<std::string> values;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind(start, 0) == 0) {
            values.push_back(line.substr(start.size()));
        }
    }
    return values;
}

class BrokenFile : public testing::TestWithParam<std::string> {};

TEST_P(BrokenFile, Problems_AreReportedInFull) {
    fs::current_path(kFolder);  // so that messages have relative file names
    const std::string file = GetParam() + ".yaml";
    const std::string text = read(file);
    const std::vector<std::string> quality = options(text, "quality");
    const LoadResult result = load_shot(
        file, {.overrides = options(text, "set"), .quality = quality.empty() ? "" : quality[0]});
    std::string reported;
    for (const Problem& problem : result.problems) {
        reported += format(problem);
    }
    EXPECT_EQ(reported, read(GetParam() + ".expected"));
    EXPECT_FALSE(reported.empty());
    EXPECT_EQ(result.shot.has_value(), !has_errors(result.problems));
}

INSTANTIATE_TEST_SUITE_P(All, BrokenFile, testing::ValuesIn(broken_files()),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace carom::pipeline
