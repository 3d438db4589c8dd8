// Tests of the explained shot, which has the origin of each value.
#include "pipeline/config/explain.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/config/reference_examples.h"
#include "sim/bake.h"
#include "tests/folders.h"
#include "tests/pipeline/config/load.h"
#include "tests/pipeline/config/shot_text.h"
#include "tests/pipeline/film_of_shots.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

std::string explained(const LoadResult& loaded) {
    return loaded.source ? explained_yaml(*loaded.source, *loaded.shot) : std::string();
}

TEST(Explain, Values_HaveTheLineOrOptionOfTheirOrigin) {
    const LoadResult loaded = load_shot_text(R"(carom: 1
simulation: {duration: 2 s}
table: {kind: cloth}
balls:
  cue:
    at: [0, 0]
render: {samples: 16}
)",
                                             "s.yaml", {.overrides = {"render.samples=32"}});
    const std::string text = explained(loaded);
    EXPECT_THAT(text, ContainsRegex("\n  duration: 2 s +# s.yaml:2\n"));
    EXPECT_THAT(text, ContainsRegex("\n  step: 1/240 s +# default\n"));
    EXPECT_THAT(text, ContainsRegex("\n    at: \\[0, 0\\] +# s.yaml:6\n"));
    EXPECT_THAT(text, ContainsRegex("\n  samples: 32 +# --set\n"));
    EXPECT_THAT(text, ContainsRegex("\nphysics:\n  gravity: 9.81 m/s\\^2 +# default\n"));
    EXPECT_THAT(text, Not(HasSubstr("rack:")));  // the shot has no rack
}

TEST(Explain, ShortSide_HasTheSizeOfThePicture) {
    const std::string text = explained(
        load_shot_text("carom: 1\nrender:\n  size: [1024, 768]\n  short_side: 540\n", "s.yaml"));
    EXPECT_THAT(text, ContainsRegex("\n  size: \\[1024, 768\\] +# s.yaml:3\n"));
    EXPECT_THAT(text,
                ContainsRegex("\n  short_side: 540 +# s.yaml:4, makes the picture 720x540\n"));
    const LoadResult again = load_shot_text(text, "again.yaml");
    ASSERT_TRUE(again.shot);
    EXPECT_EQ(again.shot->render.width, 720);
}

TEST(Explain, DefaultsWithoutMeaning_AreLeftOut) {
    const LoadResult loaded = load_shot_text(R"(carom: 1
lights: {sky: {environment: 0.5}}
cameras:
  - {video: [0 s, 1 s], scene: [0 s, 1 s], position: [0, -1, 1], target: [0, 0, 0], focal_length: 50 mm}
)",
                                             "s.yaml");
    const std::string text = explained(loaded);
    EXPECT_THAT(text, HasSubstr("environment: 0.5"));
    EXPECT_THAT(text, Not(HasSubstr("facing:")));
    EXPECT_THAT(text, Not(HasSubstr("fov:")));  // the focal length replaces it
    EXPECT_THAT(text, ContainsRegex("\n    sensor: 0.024 m +# default\n"));
}

TEST(Explain, Table_HasTheDimensionsOfItsKindAndSize) {
    const LoadResult loaded = load_shot_text(R"(carom: 1
table: {kind: snooker, rail_height: 45 mm, pockets: {corner: {drop: 130 mm}}}
balls: {cue: {at: [0, 0]}}
)",
                                             "s.yaml");
    const std::string text = explained(loaded);
    EXPECT_THAT(text, ContainsRegex("\n  rail_height: 45 mm +# s.yaml:2\n"));
    EXPECT_THAT(text,
                ContainsRegex("\n      drop: 130 mm +# s.yaml:2\n      # mouth: 0.088 m +# of "
                              "the table's kind and size\n"));
    EXPECT_THAT(text,
                ContainsRegex("\n    # side:\n    #   mouth: 0.1115 m +# of the table's kind"));
    EXPECT_THAT(text, ContainsRegex("\n  # length: 3.569 m +# of the table's kind and size\n"));
    EXPECT_THAT(text, ContainsRegex("\n  # cushion_height: 0.03675 m +# of the table's kind"));
}

class ExplainedTable : public ::testing::TestWithParam<const char*> {};

TEST_P(ExplainedTable, ReadsBackAsTheSameTable) {
    const LoadResult original = load_shot_text(
        "carom: 1\ntable: {" + std::string(GetParam()) + "}\nballs: {cue: {at: [0, 0]}}\n",
        "s.yaml");
    ASSERT_TRUE(original.shot);
    const LoadResult again = load_shot_text(explained(original), "again.yaml");
    ASSERT_TRUE(again.shot) << explained(original);
    EXPECT_EQ(again.shot->world.table, original.shot->world.table) << explained(original);
}

INSTANTIATE_TEST_SUITE_P(All, ExplainedTable,
                         ::testing::Values("kind: pool", "kind: pool, size: 8 ft",
                                           "kind: pool, size: 7 ft", "kind: pool, pockets: none",
                                           "kind: snooker", "kind: carom", "kind: cloth",
                                           "kind: custom, length: 2 m, width: 1 m"));

class ExplainedExample : public ::testing::TestWithParam<const char*> {};

TEST_P(ExplainedExample, ReadsBackAsTheSameShot) {
    const std::string path = std::string(CAROM_SOURCE_DIR) + "/examples/" + GetParam() + ".yaml";
    const LoadResult original = load_shot(path);
    ASSERT_TRUE(original.shot);
    const std::string text = explained(original);
    LoadResult again = load_shot_text(text, std::string("/nowhere/") + GetParam() + ".yaml");
    EXPECT_TRUE(again.problems.empty()) << text;
    ASSERT_TRUE(again.shot);
    EXPECT_NEAR(again.shot->world.key_reduction.orientation_error,
                original.shot->world.key_reduction.orientation_error, 1e-15);
    again.shot->world.key_reduction = original.shot->world.key_reduction;  // 0.01 deg, rounded
    EXPECT_EQ(sim::physics_hash(again.shot->world), sim::physics_hash(original.shot->world));
    EXPECT_EQ(again.shot->assets, original.shot->assets);
    EXPECT_EQ(shot_text(*again.shot), shot_text(*original.shot));
}

INSTANTIATE_TEST_SUITE_P(All, ExplainedExample,
                         ::testing::Values("nine_ball_break", "masse", "domino_run", "slow_motion",
                                           "distributed", "bullet_time"));

/// Without comments: where a value comes from, and measures that a table has anyway.
std::string without_comments(const std::string& text) {
    std::istringstream lines(text);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t comment = line.rfind("  # ");
        if (comment != std::string::npos) {
            line.resize(line.find_last_not_of(' ', comment) + 1);
        }
        const std::size_t first = line.find_first_not_of(' ');
        if (first != std::string::npos && line[first] != '#') {
            result += line + "\n";
        }
    }
    return result;
}

/// The shot has no problem, the loader accepts every default that its explained text has, and with
/// these it explains to the same text.
void expect_defaults_are_accepted(const LoadResult& original) {
    EXPECT_EQ(all_problems(original), "");
    const std::string text = explained(original);
    const LoadResult again = load_shot_text(text, "/nowhere/explained.yaml");
    EXPECT_EQ(all_problems(again), "") << text;
    EXPECT_EQ(without_comments(explained(again)), without_comments(text));
}

TEST(ExplainedDefaults, OfExamples_AreAccepted) {
    int count = 0;
    // Each line of an explained text names its file; with relative names its size is the same
    // wherever the sources are.
    std::filesystem::current_path(CAROM_SOURCE_DIR);
    for (const char* folder : {"examples", "examples/gallery", "examples/texts"}) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            if (entry.path().extension() == ".yaml" &&
                !carom::testing::is_film_of_shots(entry.path())) {
                SCOPED_TRACE(entry.path().string());
                expect_defaults_are_accepted(load_shot(entry.path().string()));
                ++count;
            }
        }
    }
    EXPECT_GT(count, 30);
}

TEST(ExplainedDefaults, OfReferenceExamples_AreAccepted) {
    const carom::testing::ScratchFolder folder;
    std::ofstream(folder.path("logo.png"));    // of the example with a picture
    std::ofstream(folder.path("piano.flac"));  // and the one with music
    for (const auto& [section, yaml] : config::reference_examples()) {
        if (yaml.starts_with("film:")) {  // no shot
            continue;
        }
        SCOPED_TRACE(section);
        const bool has_camera = yaml.find("cameras:") != std::string::npos;
        expect_defaults_are_accepted(load_shot_text(
            "carom: 1\n" + (has_camera ? "" : kCamera) + yaml, folder.path("shot.yaml")));
    }
}

class ExplainedDefault : public ::testing::TestWithParam<std::string> {};

TEST_P(ExplainedDefault, IsAccepted) {
    const bool has_camera = GetParam().starts_with("cameras:");
    expect_defaults_are_accepted(
        load_shot_text("carom: 1\ntable: {kind: pool}\nballs: {cue: {at: [0, 0]}}\n" +
                           (has_camera ? "" : kCamera) + GetParam(),
                       std::string(CAROM_SOURCE_DIR) + "/tests/pipeline/config/shot.yaml"));
}

/// A camera with these keys; `position` is one of them.
std::string camera(const std::string& keys) {
    return "cameras: [{video: [0 s, 1 s], scene: [0 s, 1 s], target: [0, 0, 0], " + keys + "}]\n";
}

INSTANTIATE_TEST_SUITE_P(Light, ExplainedDefault,
                         ::testing::Values("lights: {a: {point: 1}}", "lights: {a: {spot: 1}}",
                                           "lights: {a: {directional: 1}}",
                                           "lights: {a: {rectangle: [1 m, 1 m]}}",
                                           "lights: {a: {sphere: 0.1 m}}",
                                           "lights: {a: {environment: 1}}",
                                           "lights: {a: {environment: {turbidity: 3}}}"));
INSTANTIATE_TEST_SUITE_P(
    CameraPath, ExplainedDefault,
    ::testing::Values(camera("position: {bezier: [[0, -1, 1], [0, -2, 1]]}"),
                      camera("position: {spline: [[0, -1, 1], [0, -2, 1]]}"),
                      camera("position: {along: cue, from: 0 s, to: 1 s, offset: [0, -1, 1]}"),
                      camera("position: {follow: cue, offset: [0, -1, 1]}"),
                      camera("position: {orbit: [0, 0, 1], radius: 1 m}"),
                      camera("position: {orbit: cue, radius: 1 m, offset: [0, 0, 1]}")));
INSTANTIATE_TEST_SUITE_P(
    Lens, ExplainedDefault,
    ::testing::Values(camera("position: [0, -1, 1], fov: 30 deg, f_number: 4"),
                      camera("position: [0, -1, 1], focal_length: 50 mm, aperture: 5 mm"),
                      camera("position: [0, -1, 1], f_number: {from: 2, to: 4}")));
INSTANTIATE_TEST_SUITE_P(
    Object, ExplainedDefault,
    ::testing::Values(
        "objects: {a: {box: [1 cm, 1 cm, 1 cm], at: [0.5, 0, 0.3]}}",
        "objects: {a: {box: [1 cm, 1 cm, 1 cm], at: [0.5, 0, 0.3], physics: false}}",
        "objects: {a: {box: [1 cm, 1 cm, 1 cm], at: [0.5, 0, 0.3], physics: fixed}}",
        "objects: {a: {box: [1 cm, 1 cm, 1 cm], at: [0.5, 0, 0.3], physics: {mass: 9 g}}}",
        "objects: {a: {mesh: files/triangle.obj, at: [0.5, 0, 0.3], physics: fixed}}",
        "objects: {a: {sphere: 1 cm, at: [0.5, 0, 0.3], axes: [[1, 0, 0], [0, 1, 0], [0, 0, 2]]}}",
        "objects: {a: {disk: 1 cm, at: [0.5, 0, 0.3], rotate: [10 deg, 0, 0]}}",
        "objects: {a: {sphere: 1 cm, at: [0.5, 0, 0.3], physics: true, motion: {keys: [{at: 0 s}, "
        "{at: 1 s, position: [0.6, 0, 0.3]}]}}}"));
INSTANTIATE_TEST_SUITE_P(Shutter, ExplainedDefault,
                         ::testing::Values("render: {shutter: {angle: 90 deg}}",
                                           "render: {shutter: {time: 1/48 s}}"));

}  // namespace
}  // namespace carom::pipeline
