// The section `solve`: what is read, what is found, and what is refused.
#include <algorithm>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/config/load_shot.h"
#include "pipeline/config/measures/measures.h"
#include "pipeline/solve/solver.h"
#include "sim/bake.h"
#include "tests/pipeline/config/shot_text.h"

namespace carom::pipeline {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kShot = R"(carom: 1
table: {size: 9 ft}
balls:
  cue: {at: [-0.4, -0.1]}
  one: {at: [0.8, 0.3]}
  two: {at: [-0.9, 0.4]}
)";

std::vector<std::string> messages(const LoadResult& result) {
    std::vector<std::string> all;
    for (const Problem& problem : result.problems) {
        if (problem.severity == Severity::error) {
            all.push_back(problem.message);
        }
    }
    return all;
}

LoadResult load(const std::string& rest) {
    return load_shot_text(kShot + rest, "shot.yaml");
}

TEST(SolveSection, StrikeIsFound_AndWritten) {
    const LoadResult result = load(R"(events:
  - strike: {ball: cue}
solve: {want: [{potted: one}]}
)");
    ASSERT_TRUE(result.shot) << testing::PrintToString(messages(result));
    ASSERT_EQ(result.shot->solved.size(), 1U);
    EXPECT_EQ(result.shot->solved[0].event, 0U);
    const sim::Timeline timeline = sim::bake(result.shot->world);
    EXPECT_TRUE(std::ranges::any_of(timeline.events, [](const sim::Event& event) {
        return event.kind == sim::EventKind::potted && event.a == "one";
    }));
    // The text has the strike instead of `solve`, and is the same world.
    const std::string& text = result.shot->resolved_text;
    EXPECT_THAT(text, Not(HasSubstr("solve")));
    EXPECT_THAT(text, HasSubstr("direction: "));
    const LoadResult again = load_shot_text(text, "again.yaml");
    ASSERT_TRUE(again.shot) << testing::PrintToString(messages(again));
    EXPECT_EQ(sim::physics_hash(again.shot->world), sim::physics_hash(result.shot->world));
}

TEST(SolveSection, GivenValuesStay_AndOthersAreFound) {
    const LoadResult result = load(R"(events:
  - strike: {ball: cue, speed: 2.7 m/s, tip: [0.1, 0.2]}
solve: {want: [{potted: one, in: top right}]}
)");
    ASSERT_TRUE(result.shot) << testing::PrintToString(messages(result));
    const auto& strike = std::get<sim::Strike>(result.shot->world.events[0].action);
    EXPECT_EQ(strike.speed, 2.7);
    EXPECT_EQ(strike.tip, Vec2(0.1, 0.2));
    EXPECT_NE(strike.direction, 0);
}

TEST(SolveSection, BallInTheWay_IsPassedWithARaisedStick) {
    const std::string rest = R"(  eight: {at: [-0.1, 0]}
events:
  - strike: {ball: cue}
solve:
  want: [{contact: [cue, one]}]
  avoid:
    - {contact: [cue, eight]}
    - {contact: [cue, cushion], before: {contact: [cue, one]}}
)";
    const LoadResult result = load(rest);
    ASSERT_TRUE(result.shot) << testing::PrintToString(messages(result));
    const auto& strike = std::get<sim::Strike>(result.shot->world.events[0].action);
    EXPECT_GT(strike.elevation, 0);
    EXPECT_THAT(result.shot->resolved_text, HasSubstr("elevation: "));
    // Without the ball in the way, and where the elevation is given, it stays.
    const LoadResult level =
        load(rest.substr(rest.find('\n') + 1,
                         rest.find("    - {contact: [cue, eight") - rest.find('\n') - 1) +
             rest.substr(rest.find("    - {contact: [cue, cushion")));
    ASSERT_TRUE(level.shot) << testing::PrintToString(messages(level));
    EXPECT_EQ(std::get<sim::Strike>(level.shot->world.events[0].action).elevation, 0);
    std::string given = rest;
    given.replace(given.find("{ball: cue}"), 11, "{ball: cue, elevation: 0 deg}");
    EXPECT_THAT(messages(load(given)), ElementsAre(HasSubstr("no strike was found")));
}

TEST(SolveSection, StrikesAreFoundOneAfterTheOther) {
    const LoadResult result = load(R"(events:
  - strike: {ball: cue}
  - strike: {ball: cue, when: {resting: all}}
simulation: {duration: 30 s}
solve:
  - {want: [{potted: one}]}
  - {strike: 1, want: [{potted: two}], prefer: [slow, likely], player: professional}
)");
    ASSERT_TRUE(result.shot) << testing::PrintToString(messages(result));
    std::vector<std::string> potted;
    for (const sim::Event& event : sim::bake(result.shot->world).events) {
        if (event.kind == sim::EventKind::potted) {
            potted.push_back(event.a);
        }
    }
    EXPECT_THAT(potted, ElementsAre("one", "two"));
}

/// A later aim starts from where the solved strike has left the balls.
TEST(SolveSection, AimAfterASolvedStrike_KnowsIt) {
    const LoadResult result = load(R"(events:
  - strike: {ball: cue}
  - strike: {ball: cue, when: {resting: all}, pot: two, speed: 2.5 m/s}
simulation: {duration: 30 s}
solve: {want: [{potted: one}]}
)");
    ASSERT_TRUE(result.shot) << testing::PrintToString(messages(result));
    std::vector<std::string> potted;
    for (const sim::Event& event : sim::bake(result.shot->world).events) {
        if (event.kind == sim::EventKind::potted) {
            potted.push_back(event.a);
        }
    }
    EXPECT_THAT(potted, ElementsAre("one", "two"));
    EXPECT_THAT(messages(load("events: [{strike: {ball: cue, when: {potted: one}}}]\n"
                              "solve: {want: [{potted: two}]}\n")),
                ElementsAre("the strike on 'cue' never comes"));
}

/// Three reds and the black after each: the longest of the layouts (tests/pipeline/solve).
TEST(SolveSection, RunOfSix_IsFoundStrikeByStrike) {
    if (std::getenv("CAROM_ALL_LAYOUTS") == nullptr) {
        GTEST_SKIP() << "CAROM_ALL_LAYOUTS is not set";
    }
    std::string text = R"(carom: 1
table: {kind: snooker, size: 12 ft}
respot: snooker
simulation: {duration: 90 s}
balls:
  cue: {at: [0.9, -0.15]}
  red_1: {at: [1.25, -0.35]}
  red_2: {at: [1.2, 0.3]}
  red_3: {at: [1.0, 0.45]}
  black: {at: black}
  blue: {at: blue}
  pink: {at: pink}
events:
  - strike: {ball: cue}
)";
    for (int i = 1; i < 6; ++i) {
        text += "  - strike: {ball: cue, when: {resting: all}, after: 1 s}\n";
    }
    text += R"(solve:
  - {strike: 0, want: [{potted: red_1}, {rest: cue, near: [1.1, 0], within: 0.35 m}]}
  - {strike: 1, want: [{potted: black}, {rest: cue, near: [0.9, 0.1], within: 0.4 m}]}
  - {strike: 2, want: [{potted: red_2}, {rest: cue, near: [1.0, 0], within: 0.4 m}]}
  - {strike: 3, want: [{potted: black}, {rest: cue, near: [0.7, 0.2], within: 0.4 m}]}
  - {strike: 4, want: [{potted: red_3}, {rest: cue, near: [1.0, 0], within: 0.5 m}]}
  - {strike: 5, want: [{potted: black}]}
)";
    const LoadResult result = load_shot_text(text, "run.yaml");
    ASSERT_TRUE(result.shot) << testing::PrintToString(messages(result));
    std::vector<std::string> potted;
    for (const sim::Event& event : sim::bake(result.shot->world).events) {
        if (event.kind == sim::EventKind::potted) {
            potted.push_back(event.a);
        }
    }
    EXPECT_THAT(potted, ElementsAre("red_1", "black", "red_2", "black", "red_3", "black"));
}

/// What the measure gives for a bake of the shot.
double measured(const Shot& shot, const std::string& text) {
    const sim::Timeline timeline = sim::bake(shot.world);
    sim::Outcome outcome;
    outcome.events = timeline.events;
    outcome.motion = timeline;
    const auto measure = std::get<measures::Measure>(measures::parse_measure(text, shot.world));
    return std::get<double>(measure.value({shot.world, {}, outcome}));
}

TEST(SolveSection, MeasuresAreWanted) {
    const std::string open = "events: [{strike: {ball: cue}}]\n";
    const LoadResult bank = load(open + R"(solve:
  want: [{cushions: cue}, {measure: 'rebound_angle:cue', about: 30 deg, within: 1 deg}]
)");
    ASSERT_TRUE(bank.shot) << testing::PrintToString(messages(bank));
    EXPECT_NEAR(measured(*bank.shot, "rebound_angle:cue"), 30, 1);
    const LoadResult stun = load(open + R"(solve:
  want:
    - {potted: one}
    - {measure: 'speed_after:contact,cue,one', at_most: 0.4 m/s}
    - {measure: 'time:potted,one', at_least: 2, at_most: 3 s}
)");
    ASSERT_TRUE(stun.shot) << testing::PrintToString(messages(stun));
    EXPECT_LE(measured(*stun.shot, "speed_after:contact,cue,one"), 0.4);
    EXPECT_GE(measured(*stun.shot, "time:potted,one"), 2);
    EXPECT_LE(measured(*stun.shot, "time:potted,one"), 3);
    EXPECT_FALSE(stun.shot->solved[0].result->solutions.front().outcome.motion);
}

TEST(SolveSection, MeasureOfALaterStrike_IsThatOfTheWholeShot) {
    const LoadResult result = load(R"(events:
  - strike: {ball: cue, toward: two, speed: 1 m/s}
  - strike: {ball: cue, when: {resting: all}}
solve:
  strike: 1
  want: [{contact: [cue, one]}, {measure: 'cushions:cue', at_least: 4}]
)");
    ASSERT_TRUE(result.shot) << testing::PrintToString(messages(result));
    EXPECT_GE(measured(*result.shot, "cushions:cue"), 4);
}

TEST(SolveSection, NearestMeasureIsSaid) {
    const LoadResult result = load(R"(events: [{strike: {ball: cue, speed: 1 m/s}}]
solve: {want: [{measure: 'top_speed:cue', at_least: 5 m/s}]}
)");
    EXPECT_THAT(messages(result), ElementsAre(HasSubstr(": 'top_speed:cue [m/s]' is 1.")));
}

TEST(SolveSection, WhatCannotBe_IsSaid) {
    const LoadResult result = load(R"(events:
  - strike: {ball: cue}
solve: {want: [{potted: one}, {rest: cue, near: [5, 5]}]}
)");
    EXPECT_THAT(messages(result),
                ElementsAre(AllOf(HasSubstr("no strike was found that does all this, in "),
                                  HasSubstr("; the nearest, cue - one, "),
                                  HasSubstr("'cue' rests at ["), HasSubstr(" m away"))));
    EXPECT_TRUE(std::ranges::any_of(result.problems, [](const Problem& problem) {
        return problem.severity == Severity::error && problem.place.line == 9;
    }));
}

TEST(SolveSection, MistakesAreNamed) {
    const auto said = [](const std::string& rest) { return messages(load(rest)); };
    EXPECT_THAT(said("solve: {want: [{potted: one}]}\n"),
                ElementsAre("there is no strike whose direction or speed is to be found"));
    EXPECT_THAT(said("events: [{strike: {ball: cue, direction: 0 deg, speed: 1 m/s}}]\n"
                     "solve: {strike: 3, want: [{potted: one}]}\n"),
                ElementsAre("'strike: 3' names no strike of 'events', which are numbered from 0"));
    EXPECT_THAT(said("events: [{strike: {ball: cue, direction: 0 deg, speed: 1 m/s, tip: [0, 0]}}]"
                     "\nsolve: {strike: 0, want: [{potted: one}]}\n"),
                ElementsAre("the strike gives its direction, speed and tip: nothing is left to be "
                            "found"));
    const std::string open = "events: [{strike: {ball: cue}}]\n";
    EXPECT_THAT(said(open + "solve: {want: [{potted: on}]}\n"),
                ElementsAre(HasSubstr("there is no ball 'on'")));
    EXPECT_THAT(said(open + "solve: {want: [{potted: one, in: midle}]}\n"),
                ElementsAre(HasSubstr("there is no pocket 'midle'")));
    EXPECT_THAT(said(open + "solve: {want: [{contact: [cue, one], in: top right}]}\n"),
                ElementsAre(HasSubstr("'in'")));
    EXPECT_THAT(said(open + "solve: {want: [{contact: [cue, one], at_least: 3, at_most: 2}]}\n"),
                ElementsAre("'at_most' must not be less than 'at_least'"));
    EXPECT_THAT(said(open + "solve: {want: [{potted: one, before: {resting: cue}}]}\n"),
                ElementsAre("'before' takes a contact, a cushion or a pot, without 'nth' and "
                            "'after'"));
    EXPECT_THAT(said(open + "solve: {want: [{potted: one}], avoid: [{rest: cue, near: [0, 0]}]}\n"),
                ElementsAre("'avoid' takes 'potted', 'contact' and 'cushions', without 'at_most'"));
    EXPECT_THAT(said(open + "solve: {want: []}\n").size(), 1U);
    EXPECT_THAT(said(open + "solve: {want: [{potted: one}, {rest: one, near: [0, 0]}]}\n"),
                ElementsAre("'one' cannot be potted and come to rest on the table"));
    EXPECT_THAT(
        said(open + "solve: {want: [{potted: one, in: top right}], avoid: [{potted: one}]}\n"),
        ElementsAre("the pot of 'one' is wanted and avoided"));
    EXPECT_THAT(said(open + "solve: {want: [{contact: [cue, one], at_least: 2}], avoid: [{contact: "
                            "[one, cue], at_least: 2}]}\n"),
                ElementsAre("the contact of 'cue' and 'one' is wanted and avoided"));
}

TEST(SolveSection, MistakesOfMeasuresAreNamed) {
    const auto said = [](const std::string& want) {
        return messages(
            load("events: [{strike: {ball: cue}}]\nsolve: {want: [{measure: " + want + "}]}\n"));
    };
    EXPECT_THAT(said("'rebound_angel:cue', at_least: 30 deg"),
                ElementsAre("there is no measure 'rebound_angel' (did you mean 'rebound_angle'?); "
                            "'carom sweep --measures' lists them"));
    EXPECT_THAT(said("'rebound_angle:cua', at_least: 30 deg"),
                ElementsAre("there is no ball or object 'cua' (did you mean 'cue'?)"));
    EXPECT_THAT(
        said("'pocket:one', at_least: 1"),
        ElementsAre("'pocket' is a name, not a number; write '{potted: BALL, in: POCKET}'"));
    EXPECT_THAT(said("'rebound_angle:cue', at_least: 30 m"),
                ElementsAre("'at_least' must be an angle (rad, deg, turn), not a length ('30 m')"));
    EXPECT_THAT(said("'rebound_angle:cue', at_least: 30"),
                ElementsAre("'at_least' is an angle and needs a unit; write '30 deg'"));
    EXPECT_THAT(said("'rebound_angle:cue', at_least: 30 deg, at_most: 20 deg"),
                ElementsAre("'at_most' must not be less than 'at_least'"));
    EXPECT_THAT(
        said("'rebound_angle:cue', at_least: 30 deg, at_most: 30 deg"),
        ElementsAre("'at_least' and 'at_most' are equal: no strike meets one value exactly"));
    EXPECT_THAT(said("'rebound_angle:cue', about: 30 deg, within: 0 deg"),
                ElementsAre("'within' must be more than 0 deg, not '0 deg'"));
    EXPECT_THAT(
        said("'rebound_angle:cue', about: 30 deg"),
        ElementsAre("'about' needs 'within', which says how far from it the measure may be"));
    EXPECT_THAT(said("'rebound_angle:cue', at_most: 30 deg, within: 1 deg"),
                ElementsAre("'within' needs 'about'"));
    const char* unbounded =
        "a measure is wanted 'at_least', 'at_most' or both, or 'about' a value and 'within' a "
        "distance from it";
    EXPECT_THAT(said("'rebound_angle:cue'"), ElementsAre(unbounded));
    EXPECT_THAT(said("'rebound_angle:cue', at_least: 3 deg, about: 4 deg, within: 1 deg"),
                ElementsAre(unbounded));
}

}  // namespace
}  // namespace carom::pipeline
