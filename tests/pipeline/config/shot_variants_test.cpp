#include "pipeline/config/shot_variants.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "shot_text.h"
#include "tests/folders.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using ::testing::ElementsAre;
using ::testing::Optional;

std::string example(const std::string& name) {
    return CAROM_SOURCE_DIR "/examples/" + name + ".yaml";
}

std::string text_of(const sim::WorldDescription& world) {
    Shot shot;
    shot.world = world;
    return shot_text(shot);
}

std::vector<std::string> as_overrides(const std::vector<VariedValue>& values) {
    std::vector<std::string> texts;
    for (const VariedValue& value : values) {
        texts.push_back(value.key + "=" + value.text);
    }
    return texts;
}

std::vector<std::string> messages(const std::vector<Problem>& problems) {
    std::vector<std::string> all;
    for (const Problem& problem : problems) {
        all.push_back(format(problem));
    }
    return all;
}

/// As load_shot gives them with --set.
void expect_as_loaded(const std::string& path, const std::vector<VariedValue>& values) {
    SCOPED_TRACE(path);
    const LoadResult loaded = load_shot(path, {.overrides = as_overrides(values)});
    const ShotVariants variants(path, {}, "--set");
    const ShotVariants::World read = variants.world(values);
    ASSERT_EQ(loaded.shot.has_value(), read.world.has_value());
    if (!loaded.shot) {
        EXPECT_EQ(messages(read.problems), messages(loaded.problems));
        return;
    }
    EXPECT_EQ(text_of(*read.world), text_of(loaded.shot->world));
    const bool are_events = std::ranges::all_of(
        values, [](const VariedValue& value) { return is_in_events(value.key); });
    if (are_events) {
        const ShotVariants::Events events = variants.events(values);
        ASSERT_TRUE(events.events.has_value());
        sim::WorldDescription world = variants.own_world();
        world.events = *events.events;
        EXPECT_EQ(text_of(world), text_of(loaded.shot->world));
    }
}

TEST(ShotVariants_OfExamples, AreWhatIsLoadedWithOverrides) {
    for (const char* name : {"bank_shot", "masse", "jump_shot", "three_cushion",
                             "snooker_break_off", "nine_ball_break"}) {
        expect_as_loaded(example(name), {});
        expect_as_loaded(example(name), {{"events[0].strike.elevation", "3 deg"}});
        expect_as_loaded(example(name), {{"events[0].strike.tip", "[0.1, -0.2]"},
                                         {"events[0].strike.tip_restitution", "0.8"}});
        expect_as_loaded(example(name), {{"physics.ball_cushion.model", "mirror"},
                                         {"events[0].strike.elevation", "3 deg"}});
        expect_as_loaded(example(name), {{"simulation.duration", "2 s"}});
        expect_as_loaded(example(name),
                         {{"physics.cushions", "lively"}, {"physics.tip", "phenolic"}});
        expect_as_loaded(example(name), {{"balls.cue.at", "[0.1, 0.05]"}});
    }
    expect_as_loaded(example("domino_run"), {{"physics.gravity", "[0, 0, -5]"}});
    expect_as_loaded(example("tower"), {{"simulation.step", "5 ms"}});
}

TEST(ShotVariants_OfAims, AimAgain) {
    const std::string path = example("thirty_degrees");  // hit: one, fullness: 1/2
    expect_as_loaded(path, {{"events[0].strike.tip", "[0.3, 0.2]"}});
    expect_as_loaded(path, {{"events[0].strike.fullness", "3/4"}});
    expect_as_loaded(path, {{"balls.one.at", "[0.3, 0.2]"}});
    expect_as_loaded(path, {{"events[0].strike.speed", "0.1 m/s"}});  // does not get there
}

TEST(ShotVariants_WithProblems, HaveThoseOfLoadedShots) {
    const std::string path = example("bank_shot");
    expect_as_loaded(path, {{"events[0].strike.speed", "-1 m/s"}});
    expect_as_loaded(path, {{"events[0].strike.speed", "[1"}});
    expect_as_loaded(path, {{"events[7].strike.speed", "1 m/s"}});
    expect_as_loaded(path, {{"balls.nine.at", "[0.55, -0.34]"}});
    expect_as_loaded(path, {{"physics.ball_bal.restitution", "0.9"}});
    expect_as_loaded(path, {{"table.size", "3 ft"}, {"physics.cloth", "wett"}});
}

TEST(ShotVariants_Events, ReportTheirOwnProblemsAtTheTextOfTheValue) {
    const ShotVariants variants(example("bank_shot"), {}, "--vary");
    const std::vector<VariedValue> wrong{{"events[0].strike.speed", "3 kg"}};
    const ShotVariants::Events read = variants.events(wrong);
    EXPECT_FALSE(read.events.has_value());
    EXPECT_THAT(
        messages(read.problems),
        ElementsAre("--vary:1:24: error: 'speed' must be a speed (m/s, km/h, mph), not a mass ('3 "
                    "kg')\n    1 | events[0].strike.speed=3 kg\n"
                    "      |                        ^~~~\n"));
}

TEST(ShotVariants_Texts, AreThoseOfTheShotAfterItsConditions) {
    const ShotVariants variants(example("bank_shot"), {}, "--vary");
    EXPECT_THAT(variants.text_of("events[0].strike.direction"), Optional(std::string("116.9 deg")));
    EXPECT_THAT(variants.text_of("balls.cue.at[1]"), Optional(std::string("-0.35")));
    EXPECT_EQ(variants.text_of("balls.cue.at"), std::nullopt);
    EXPECT_EQ(variants.text_of("balls.ten.at[1]"), std::nullopt);
    EXPECT_EQ(variants.text_of("physics.gravity[2].z"), std::nullopt);
}

TEST(ShotVariants_Keys, ChangeTheMotionOrNot) {
    EXPECT_TRUE(can_change_motion("events[0].strike.speed"));
    EXPECT_TRUE(can_change_motion("conditions.cloth.wet.ball_cloth.sliding_friction"));
    EXPECT_TRUE(can_change_motion("evnts[0]"));
    EXPECT_FALSE(can_change_motion("render.samples"));
    EXPECT_FALSE(can_change_motion("cameras[0].fov"));
    EXPECT_TRUE(is_in_events("events[0]"));
    EXPECT_FALSE(is_in_events("physics.cloth"));
}

TEST(ShotVariants_OfAShotWithErrors, CannotBeMade) {
    EXPECT_THROW(ShotVariants("nowhere.yaml", {}, "--vary"), Error);
    const carom::testing::ScratchFolder folder;
    const std::string path = folder.path("wrong.yaml");
    carom::testing::write_text(path, "carom: 1\nballs: {cue: {att: [0, 0]}}\n");
    EXPECT_THROW(ShotVariants(path, {}, "--vary"), Error);
}

}  // namespace
}  // namespace carom::pipeline
