// Strikes that are given by what they shall do: keys, pockets' names, messages, and the text with
// the directions that were found.
#include <cmath>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "load.h"
#include "pipeline/config/explain.h"
#include "pipeline/config/pocket_names.h"
#include "sim/bake.h"

namespace carom::pipeline {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::string shot_of(const std::string& strike, const std::string& table = "{kind: pool}") {
    return "carom: 1\n" + kCamera + "table: " + table +
           "\nballs: {cue: {at: [-0.5, 0.1]}, one: {at: [0.4, 0.2]}}\n"
           "events: [{strike: {ball: cue, speed: 2.5 m/s, " +
           strike + "}}]\n";
}

const sim::Strike& strike_of(const Shot& shot) {
    return std::get<sim::Strike>(shot.world.events.at(0).action);
}

std::string problem(const std::string& strike, const std::string& table = "{kind: pool}") {
    return first_problem(shot_of(strike, table));
}

/// The pocket into which the ball falls.
std::string pocket_of(const Shot& shot, const std::string& ball) {
    for (const sim::Event& event : sim::bake(shot.world).events) {
        if (event.kind == sim::EventKind::potted && event.a == ball) {
            return event.b;
        }
    }
    return {};
}

TEST(Aims, PotInThePocketThatIsNamed) {
    EXPECT_EQ(pocket_of(load(shot_of("pot: one")), "one"), "corner_right_back");
    EXPECT_EQ(pocket_of(load(shot_of("pot: one, in: corner_right_front")), "one"),
              "corner_right_front");
    EXPECT_EQ(pocket_of(load(shot_of("pot: one, in: bottom right, tip: [0.3, 0]")), "one"),
              "corner_right_front");
}

TEST(Aims, GiveADirectionThatPhysicsAndTextHave) {
    const Shot shot = load(shot_of("pot: one, in: top right, elevation: 3 deg"));
    ASSERT_TRUE(strike_of(shot).direction);
    EXPECT_FALSE(strike_of(shot).toward_point);
    EXPECT_THAT(shot.resolved_text, AllOf(HasSubstr("direction: "), Not(HasSubstr("pot:")),
                                          Not(HasSubstr("in: top right"))));
    // Read back it is the same shot to the last bit, and nothing is left to find.
    const Shot again = load(shot.resolved_text);
    EXPECT_EQ(sim::physics_hash(again.world), sim::physics_hash(shot.world));
    EXPECT_THAT(again.found_directions, IsEmpty());
    ASSERT_EQ(shot.found_directions.size(), 1u);
    EXPECT_EQ(shot.found_directions[0].radians(), *strike_of(again).direction);
}

TEST(Aims, AreExplainedWithTheirDirections) {
    const std::string text = shot_of("cut: 30 deg, of: one, side: left, stick: hidden");
    const LoadResult result = load_shot_text(text, "t.yaml");
    ASSERT_TRUE(result.shot) << all_problems(result);
    const std::string explained = explained_yaml(*result.source, *result.shot);
    EXPECT_THAT(explained, ::testing::ContainsRegex("direction: [0-9.-]+ deg +# t.yaml:5, "
                                                    "\\{cut: 30 deg, of: one, side: left\\}"));
    EXPECT_THAT(explained, Not(HasSubstr("side: left  ")));
}

TEST(Aims, AreNotSoughtAgainWhenMomentsAreResolved) {
    const std::string text =
        "carom: 1\n"
        "cameras: [{video: [0 s, 1 s], scene: [0 s, {potted: one}], position: [0, -2, 1], target: "
        "[0, 0, 0]}]\n"
        "table: {kind: pool}\nballs: {cue: {at: [-0.5, 0.1]}, one: {at: [0.4, 0.2]}}\n"
        "events: [{strike: {ball: cue, speed: 2.5 m/s, pot: one}}]\n";
    LoadResult result = load_shot_text(text, "t.yaml");
    ASSERT_TRUE(result.shot) << all_problems(result);
    const double direction = *strike_of(*result.shot).direction;
    const sim::Timeline timeline = sim::bake(result.shot->world);
    EXPECT_THAT(resolve_moments(*result.shot, result.source, timeline), IsEmpty());
    EXPECT_FALSE(has_open_moments(*result.shot));
    EXPECT_EQ(*strike_of(*result.shot).direction, direction);
    EXPECT_THAT(result.shot->resolved_text,
                AllOf(HasSubstr("direction: "), Not(HasSubstr("pot:"))));
    EXPECT_THAT(explained_yaml(*result.source, *result.shot), HasSubstr("{pot: one}"));
}

TEST(Aims, TowardAPocketPointAtItsMiddle) {
    for (const char* name : {"corner_left_back", "top left"}) {
        const Shot shot = load(shot_of(std::string("toward: ") + name));
        ASSERT_TRUE(strike_of(shot).toward_point) << name;
        EXPECT_LT(strike_of(shot).toward_point->x, -1.27);
        EXPECT_GT(strike_of(shot).toward_point->y, 0.635);
    }
}

TEST(Aims, TakeFractionsAndWordsForTheFullness) {
    const auto direction = [](const std::string& fullness) {
        return *strike_of(load(shot_of("hit: one, " + fullness))).direction;
    };
    EXPECT_EQ(direction("fullness: 1/2, side: left"), direction("fullness: 0.5, side: left"));
    EXPECT_EQ(direction("fullness: thin, side: left"), direction("fullness: 1/8, side: left"));
    EXPECT_EQ(direction("fullness: full"), direction("fullness: 1, side: right"));
    EXPECT_EQ(direction("side: left"), direction("fullness: full"));
    // Half-ball: the centre's path passes the other centre by one radius.
    const double middle = std::atan2(0.1, 0.9);
    const double aside = std::asin(0.028575 / std::hypot(0.1, 0.9));
    EXPECT_NEAR(direction("fullness: 1/2, side: left"), middle + aside, 2e-6);
    EXPECT_NEAR(direction("fullness: 1/2, side: right"), middle - aside, 2e-6);
}

TEST(Aims, PassThroughAPoint) {
    const Shot shot = load(shot_of("through: [0.3, 0.5]"));
    EXPECT_NEAR(*strike_of(shot).direction, std::atan2(0.4, 0.8), 1e-5);
}

TEST(Aims, OfLaterStrikesAreFoundToo) {
    const std::string text =
        "carom: 1\n" + kCamera +
        "table: {kind: pool}\nsimulation: {duration: 30 s}\n"
        "balls: {cue: {at: [-0.5, 0.1]}, one: {at: [0.4, 0.2]}, two: {at: [0.8, -0.3]}}\n"
        "events:\n"
        "  - strike: {ball: cue, at: 0.5 s, pot: one, speed: 2.5 m/s}\n"
        "  - strike: {ball: cue, when: {resting: all}, pot: two, speed: 2 m/s}\n";
    const Shot shot = load(text);
    EXPECT_EQ(pocket_of(shot, "one"), "corner_right_back");
    EXPECT_NE(pocket_of(shot, "two"), "");
}

TEST(Aims, ThatCannotBeAreErrorsAtTheirPlaces) {
    const LoadResult result =
        load_shot_text(shot_of("at: 0.5 s, pot: one, in: corner_left_back"), "t.yaml");
    ASSERT_EQ(result.problems.size(), 1u);
    EXPECT_EQ(format(result.problems[0]).substr(0, 122),
              "t.yaml:5:58: error: 'one' cannot be potted in corner_left_back: the cut would be "
              "161.2 deg, and has to be less than 90 deg");
    EXPECT_THAT(problem("cut: 89.9 deg, of: one, side: left"),
                ::testing::StartsWith("'cue' cannot cut 'one' by 89.9 deg; the nearest is 89."));
    EXPECT_EQ(problem("pot: one", "{kind: carom}"), "the table has no pockets");
}

TEST(AimKeys, ContradictEachOther) {
    EXPECT_EQ(problem("stick: hidden"),
              "'strike' of event 1 needs one of 'toward', 'direction', 'pot', 'cut', 'hit' or "
              "'through'");
    EXPECT_EQ(problem("direction: 3 deg, pot: one"),
              "'pot' contradicts 'direction' in 'strike' of event 1; give only one of them");
}

TEST(AimKeys, ThatBelongTogetherAreNeeded) {
    EXPECT_EQ(problem("direction: 3 deg, in: top left"), "'in' has no meaning without 'pot'");
    EXPECT_EQ(problem("pot: one, side: left"), "'side' has no meaning without 'cut' or 'hit'");
    EXPECT_EQ(problem("pot: one, of: one"), "'of' has no meaning without 'cut'");
    EXPECT_EQ(problem("cut: 3 deg, of: one, side: left, fullness: 1/2"),
              "'fullness' has no meaning without 'hit'");
    EXPECT_EQ(problem("cut: 30 deg, side: left"), "'cut' needs the key 'of'");
    EXPECT_EQ(problem("cut: 30 deg, of: one"), "'cut' needs the key 'side'");
    EXPECT_EQ(problem("hit: one, fullness: 1/2"),
              "'hit' needs the key 'side', unless its 'fullness' is full");
}

TEST(AimKeys, HaveValuesThatMakeSense) {
    EXPECT_EQ(problem("cut: 90 deg, of: one, side: left"),
              "'cut' must be at least 0 deg and less than 90 deg, not '90 deg'");
    EXPECT_EQ(problem("cut: 30, of: one, side: left"),
              "'cut' is an angle and needs a unit; write '30 deg'");
    EXPECT_EQ(problem("hit: one, fullness: 0, side: left"),
              "'fullness' must be more than 0 and at most 1, not '0'");
    EXPECT_EQ(problem("hit: one, fullness: 3/2, side: left"),
              "'fullness' must be more than 0 and at most 1, not '3/2'");
    EXPECT_EQ(problem("hit: one, fullness: thn, side: left"),
              "'fullness' must be one of full and thin or a number, not 'thn'");
    EXPECT_EQ(problem("hit: one, fullness: 1/2, side: lift"),
              "'side' must be one of left and right, not 'lift' (did you mean 'left'?)");
    EXPECT_EQ(problem("through: [0.3]"), "'through' must be a list of 2 lengths, not of 1");
    EXPECT_EQ(problem("pot: cue"), "a ball cannot be aimed at itself");
    EXPECT_EQ(problem("pot: on"), "there is no ball 'on' (did you mean 'one'?)");
    EXPECT_EQ(problem("hitt: one"),
              "unknown key 'hitt' in 'strike' of event 1 (did you mean 'hit'?)");
}

TEST(PocketNames, AreThoseOfTheTable) {
    EXPECT_EQ(problem("pot: one, in: corner_right_bak"),
              "there is no pocket 'corner_right_bak' (did you mean 'corner_right_back'?); the "
              "pockets of the table are 'corner_left_front', 'side_front', 'corner_right_front', "
              "'corner_right_back', 'side_back' and 'corner_left_back'");
    EXPECT_EQ(problem("pot: one, in: top left", "{kind: carom}"),
              "'top left' would be a pocket of the table, and this table has none");
    EXPECT_EQ(problem("pot: one, in: top left", "{kind: snooker}"),
              "'top left' is ambiguous: it is 'corner_left_back' in the plan, but players of "
              "snooker call the end of the black spot the top; say 'corner_left_front', "
              "'side_front', 'corner_right_front', 'corner_right_back', 'side_back' or "
              "'corner_left_back'");
    EXPECT_EQ(first_problem("carom: 1\n" + kCamera +
                            "balls: {cue: {at: [0, 0]}, one: {at: [1, 0]}}\n"
                            "events: [strike: {ball: cue, pot: one, in: top left, speed: 2}]\n"),
              "'top left' would be a pocket of the table, and the shot has no table");
}

TEST(PocketNames, OfPlayersAreSeenInThePlan) {
    using namespace config;
    const auto pool = *sim::billiards::standard_table(sim::billiards::TableKind::pool, "9 ft");
    EXPECT_THAT(players_pocket_names(pool),
                ElementsAre("bottom left", "bottom side", "bottom right", "top right", "top side",
                            "top left"));
    EXPECT_EQ(pocket_of_name(pool, "top side"), "side_back");
    EXPECT_EQ(pocket_of_name(pool, "corner_left_front"), "corner_left_front");
    EXPECT_EQ(pocket_of_name(pool, "top"), "");
    const auto snooker =
        *sim::billiards::standard_table(sim::billiards::TableKind::snooker, "12 ft");
    EXPECT_THAT(players_pocket_names(snooker), IsEmpty());
    EXPECT_EQ(ambiguous_pocket(snooker, "top side"), "side_back");
    EXPECT_EQ(ambiguous_pocket(pool, "top side"), "");
}

}  // namespace
}  // namespace carom::pipeline
