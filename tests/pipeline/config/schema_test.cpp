// Compares the JSON Schema with the parser, for every example and every broken file.
#include "pipeline/config/schema.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "pipeline/config/load_shot.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/shot_source.h"
#include "tests/folders.h"
#include "tests/pipeline/config/yaml_as_json.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;
using carom::testing::to_json;
using nlohmann::json;

std::string read(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

class SchemaCheck {
  public:
    SchemaCheck() {
        const json document = json::parse(schema_json());
        const valijson::adapters::NlohmannJsonAdapter adapter(document);
        valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
        parser.populateSchema(adapter, schema_);
    }

    /// The problems that the schema finds; no value if the file is not valid YAML.
    [[nodiscard]] std::optional<std::string> complaints(const fs::path& file) const {
        config::SourceSet sources;
        config::ProblemList problems(sources);
        const int source = sources.add({file.string(), file.parent_path().string(), read(file)});
        const std::optional<config::Node> root = config::parse_yaml(sources, source, problems);
        if (!root || problems.has_error()) {
            return std::nullopt;
        }
        const json document = to_json(*root);
        valijson::Validator validator;
        valijson::ValidationResults results;
        if (validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(document),
                               &results)) {
            return "";
        }
        std::string text;
        for (const auto& result : results) {
            for (const std::string& part : result.context) {
                text += part;
            }
            text += ": " + result.description + "\n";
        }
        return text;
    }

  private:
    valijson::Schema schema_;
};

const fs::path kSource = CAROM_SOURCE_DIR;

TEST(Schema, File_MatchesTheTableOfKeys) {
    const std::string made = schema_json();
    if (read(kSource / "configs/carom.schema.json") != made) {
        std::ofstream(std::string(CAROM_BINARY_DIR) + "/carom.schema.json") << made;
        FAIL() << "configs/carom.schema.json is not up to date; copy carom.schema.json from the "
                  "build folder over it";
    }
}

TEST(Schema, AcceptsEveryExampleAndConfig) {
    const SchemaCheck schema;
    int count = 0;
    for (const char* folder : {"examples", "configs"}) {
        for (const auto& entry : fs::recursive_directory_iterator(kSource / folder)) {
            if (entry.path().extension() == ".yaml") {
                EXPECT_EQ(schema.complaints(entry.path()).value_or("no YAML"), "") << entry.path();
                ++count;
            }
        }
    }
    EXPECT_GT(count, 20);
}

/// tests/broken/schema.txt has for each broken file whether a schema can find its fault: "sees" (it
/// does), "cannot" (the fault is in the combination of values, in other files or in options), or
/// "no yaml".
TEST(Schema, FindsTheFaultsOfBrokenFilesThatItCan) {
    const SchemaCheck schema;
    std::set<std::string> lines;
    for (const auto& entry : fs::directory_iterator(kSource / "tests/broken")) {
        if (entry.path().extension() == ".yaml") {
            const std::optional<std::string> complaints = schema.complaints(entry.path());
            if (complaints &&
                !complaints->empty()) {  // the schema is never stricter than the parser
                EXPECT_TRUE(has_errors(load_shot(entry.path().string()).problems)) << entry.path();
            }
            lines.insert(entry.path().stem().string() + ": " +
                         (!complaints           ? "no yaml"
                          : complaints->empty() ? "cannot"
                                                : "sees"));
        }
    }
    std::string made;
    for (const std::string& line : lines) {
        made += line + "\n";
    }
    EXPECT_EQ(made, read(kSource / "tests/broken/schema.txt"));
}

}  // namespace
}  // namespace carom::pipeline
