// Tests of the explained shot, which has the origin of each value.
#include "pipeline/config/explain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/config/load_shot.h"
#include "sim/bake.h"
#include "tests/pipeline/config/shot_text.h"

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
                                             "s.yaml", {"render.samples=32"});
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
    EXPECT_THAT(text, ContainsRegex("\n    # side:\n    #   mouth: 0.12 m +# of the table's kind"));
    EXPECT_THAT(text, ContainsRegex("\n  # length: 3.569 m +# of the table's kind and size\n"));
    EXPECT_THAT(text, ContainsRegex("\n  # cushion_height: 0.028 m +# of the table's kind"));
}

class ExplainedTable : public testing::TestWithParam<const char*> {};

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
                         testing::Values("kind: pool", "kind: pool, size: 8 ft",
                                         "kind: pool, size: 7 ft", "kind: pool, pockets: none",
                                         "kind: snooker", "kind: carom", "kind: cloth",
                                         "kind: custom, length: 2 m, width: 1 m"));

class ExplainedExample : public testing::TestWithParam<const char*> {};

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
                         testing::Values("nine_ball_break", "masse", "domino_run", "slow_motion",
                                         "distributed", "bullet_time"));

}  // namespace
}  // namespace carom::pipeline
