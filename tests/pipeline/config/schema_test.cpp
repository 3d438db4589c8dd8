// Compares the JSON Schema with the parser, for every example and every broken file.
#include "pipeline/config/schema.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

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
        return complaints_of({file.string(), file.parent_path().string(), read(file)});
    }
    [[nodiscard]] std::optional<std::string> complaints(const std::string& text) const {
        return complaints_of({"shot.yaml", "", text});
    }

  private:
    [[nodiscard]] std::optional<std::string> complaints_of(const config::SourceText& shot) const {
        config::SourceSet sources;
        config::ProblemList problems(sources);
        const int source = sources.add(shot);
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

/// Two keys of a map of which only one may be given, and the text around them.
struct Rivals {
    std::string before;
    std::string a;
    std::string a_value;
    std::string b;
    std::string b_value;
    std::string after;

    [[nodiscard]] std::string with(const std::string& a_given, const std::string& b_given) const {
        return "carom: 1\n" + before + a + ": " + a_given + ", " + b + ": " + b_given + after;
    }
};

const std::vector<Rivals> kRivals = {
    {"materials: {felt: {standard: {base: {", "cloth", "{}", "image", "a.png", "}}}}\n"},
    {"materials: {felt: {standard: {", "normal", "a.png", "height", "{image: a.png, depth: 1 mm}",
     "}}}\n"},
    {"lights: {key: {", "point", "500", "sphere", "1 cm", "}}\n"},
    {"objects: {post: {", "sphere", "1 cm", "capsule", "{radius: 1 cm, length: 3 cm}", "}}\n"},
    {"balls: {cue: {", "at", "[0, 0]", "touching", "{ball: one, direction: 0 deg}", "}}\n"},
    {"cameras: [{include: rig.yaml, ", "fov", "30 deg", "focal_length", "50 mm", "}]\n"},
    {"output: {", "crf", "20", "bit_rate", "4 Mbit/s", "}\n"}};

TEST(Schema, KeysThatContradict_OneIsNull_Accepts) {
    const SchemaCheck schema;
    for (const Rivals& r : kRivals) {
        EXPECT_EQ(schema.complaints(r.with(r.a_value, "null")).value_or("no YAML"), "") << r.before;
        EXPECT_EQ(schema.complaints(r.with("null", r.b_value)).value_or("no YAML"), "") << r.before;
        EXPECT_EQ(schema.complaints(r.with("null", "null")).value_or("no YAML"), "") << r.before;
    }
}

TEST(Schema, KeysThatContradict_BothHaveValues_Refuses) {
    const SchemaCheck schema;
    for (const Rivals& r : kRivals) {
        EXPECT_NE(schema.complaints(r.with(r.a_value, r.b_value)).value_or(""), "") << r.before;
    }
}

/// A map in a list without `include` is merged with none.
TEST(Schema, KeysThatContradict_NullInAMapThatIsNotMerged_Refuses) {
    const SchemaCheck schema;
    const std::string text = "carom: 1\ncameras: [{fov: null, focal_length: 50 mm}]\n";
    EXPECT_NE(schema.complaints(text).value_or(""), "");
}

}  // namespace
}  // namespace carom::pipeline
