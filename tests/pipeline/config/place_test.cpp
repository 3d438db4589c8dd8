// Tests of the spots of tables, of the events that put balls somewhere, and of `respot`.
#include <gmock/gmock.h>

#include "pipeline/config/key_completion.h"
#include "tests/pipeline/config/load.h"

namespace carom::pipeline {
namespace {

using sim::PlaceBall;
using sim::Strike;

Vec3 place_of(const Shot& shot, const std::string& name) {
    for (const sim::Body& body : shot.world.bodies) {
        if (body.name == name) {
            return body.pose.position;
        }
    }
    throw std::runtime_error("no body " + name);
}

std::string problems_of(const std::string& sections) {
    return all_problems(load_shot_text("carom: 1\n" + kCamera + sections, "t.yaml"));
}

TEST(Spots, ArePlacesOfBallsAndTargets) {
    const Shot pool = load_sections(
        "table: {kind: pool}\n"
        "balls: {cue: {at: head}, eight: {at: [0.2, 0.1]}}\n"
        "events: [strike: {ball: cue, toward: foot, speed: 2}]\n");
    EXPECT_EQ(place_of(pool, "cue"), Vec3(-0.635, 0, 0.028575));
    const auto& strike = std::get<Strike>(pool.world.events.at(0).action);
    EXPECT_FALSE(strike.toward);
    EXPECT_EQ(strike.toward_point, Vec3(0.635, 0, 0));
    const Shot snooker = load_sections("table: {kind: snooker}\nballs: {black: {at: pink}}\n");
    EXPECT_EQ(place_of(snooker, "black"), Vec3(3.569 / 4, 0, 0.02625));
}

TEST(Spots, WithTheNameOfABall_AreNotAimedAt) {
    const Shot shot = load_sections(
        "table: {kind: snooker}\n"
        "balls: {white: {at: brown}, black: {at: [0.3, 0.2]}}\n"
        "events: [strike: {ball: white, toward: black, speed: 2}]\n");
    EXPECT_EQ(std::get<Strike>(shot.world.events.at(0).action).toward, "black");
}

TEST(Rack, At_MovesTheApex) {
    const std::string rack = "table: {kind: pool}\nrack: {set: nine_ball";
    const Shot usual = load_sections(rack + "}\n");
    const Shot moved = load_sections(rack + ", at: [0.5, 0.1]}\n");
    for (const char* name : {"one", "nine", "two"}) {
        EXPECT_NEAR((place_of(moved, name) - place_of(usual, name) - Vec3(-0.135, 0.1, 0)).length(),
                    0, 1e-12)
            << name;
    }
    EXPECT_EQ(place_of(load_sections(rack + ", at: head}\n"), "one"), Vec3(-0.635, 0, 0.028575));
}

TEST(PlaceEvent, Values_AreInTheWorld) {
    const Shot shot = load_sections(
        "table: {kind: snooker}\n"
        "balls: {white: {at: brown}, black: {at: [0.3, 0.2]}}\n"
        "events:\n"
        "  - place: {ball: black, spot: black, at: 1 s, after: 0.5 s, if_occupied: next}\n"
        "  - place: {ball: white, spot: [-1.2, 10 cm], when: {resting: all}}\n"
        "  - remove: {ball: black, at: 3 s}\n"
        "respot: snooker\n");
    const std::vector<sim::ForceEvent>& events = shot.world.events;
    ASSERT_EQ(events.size(), 3U);
    EXPECT_EQ(events[0].object, "black");
    EXPECT_EQ(events[0].time, 1);
    EXPECT_EQ(events[0].after, 0.5);
    const auto& first = std::get<PlaceBall>(events[0].action);
    EXPECT_EQ(first.spot, "black");
    EXPECT_NEAR(first.at.x, 3.569 / 2 - 0.324, 1e-12);
    EXPECT_EQ(first.if_occupied, PlaceBall::IfOccupied::next);
    const auto& second = std::get<PlaceBall>(events[1].action);
    EXPECT_EQ(second.spot, "");
    EXPECT_EQ(second.at, Vec2(-1.2, 0.1));
    EXPECT_EQ(second.if_occupied, PlaceBall::IfOccupied::wait);
    EXPECT_TRUE(events[1].trigger);
    EXPECT_TRUE(std::holds_alternative<sim::RemoveBall>(events[2].action));
    EXPECT_EQ(shot.world.respot, sim::billiards::Game::snooker);
    EXPECT_EQ(load_sections("").world.respot, std::nullopt);
}

TEST(UnknownSpot, ListsTheSpotsOfTheTable) {
    EXPECT_EQ(problems_of("table: {kind: pool}\nballs: {cue: {at: haed}}\n"),
              "t.yaml:4:19: error: there is no spot 'haed' (did you mean 'head'?); the spots of "
              "the table are 'foot', 'head' and 'centre'\n"
              "    4 | balls: {cue: {at: haed}}\n"
              "      |                   ^~~~\n");
    EXPECT_EQ(problems_of("table: {kind: snooker}\n"
                          "balls: {white: {at: brown}}\n"
                          "events: [place: {ball: white, spot: foot}]\n"),
              "t.yaml:5:37: error: there is no spot 'foot'; the spots of the table are 'yellow', "
              "'green', 'brown', 'blue', 'pink' and 'black'\n"
              "    5 | events: [place: {ball: white, spot: foot}]\n"
              "      |                                     ^~~~\n");
    EXPECT_EQ(problems_of("table: {kind: cloth}\nballs: {cue: {at: head}}\n"),
              "t.yaml:4:19: error: 'head' would be a spot of the table, and an unbounded cloth has "
              "none; give a point such as [0.5, 0.2]\n"
              "    4 | balls: {cue: {at: head}}\n"
              "      |                   ^~~~\n");
    EXPECT_EQ(problems_of("balls: {cue: {at: head}}\n"),
              "t.yaml:3:19: error: 'head' would be a spot of the table, and the shot has no table\n"
              "    3 | balls: {cue: {at: head}}\n"
              "      |                   ^~~~\n");
}

TEST(PlaceEvent, Problems_HaveTheirPlace) {
    EXPECT_EQ(problems_of("table: {kind: pool}\n"
                          "balls: {cue: {at: head}}\n"
                          "events:\n"
                          "  - place: {ball: cue}\n"
                          "  - place: {ball: cue, spot: 3}\n"
                          "  - place: {ball: eight, spot: foot, if_occupied: push}\n"
                          "  - remove: {at: 1 s}\n"),
              "t.yaml:6:5: error: 'place' of event 1 needs the key 'spot'\n"
              "    6 |   - place: {ball: cue}\n"
              "      |     ^~~~~\n"
              "t.yaml:7:30: error: 'spot' must be the name of a spot of the table or a list of 2 "
              "lengths, not '3'\n"
              "    7 |   - place: {ball: cue, spot: 3}\n"
              "      |                              ^\n"
              "t.yaml:8:19: error: there is no ball 'eight'\n"
              "    8 |   - place: {ball: eight, spot: foot, if_occupied: push}\n"
              "      |                   ^~~~~\n"
              "t.yaml:8:51: error: 'if_occupied' must be one of wait and next, not 'push'\n"
              "    8 |   - place: {ball: eight, spot: foot, if_occupied: push}\n"
              "      |                                                   ^~~~\n"
              "t.yaml:9:5: error: 'remove' of event 4 needs the key 'ball'\n"
              "    9 |   - remove: {at: 1 s}\n"
              "      |     ^~~~~~\n");
    EXPECT_EQ(problems_of("table: {kind: pool}\n"
                          "balls: {cue: {at: head}}\n"
                          "events:\n"
                          "  - place: {ball: cue, spot: [1.26, 0.1]}\n"
                          "  - place: {ball: cue, spot: [1.268, 0.634]}\n"
                          "  - place: {ball: cue, spot: [3, 0]}\n"),
              "t.yaml:6:24: error: event 1 on 'cue': its place overlaps a cushion by 18.58 mm\n"
              "    6 |   - place: {ball: cue, spot: [1.26, 0.1]}\n"
              "      |                        ^~~~\n"
              "t.yaml:7:24: error: event 2 on 'cue': its place is over a pocket\n"
              "    7 |   - place: {ball: cue, spot: [1.268, 0.634]}\n"
              "      |                        ^~~~\n"
              "t.yaml:8:24: error: event 3 on 'cue': its place is not on the table\n"
              "    8 |   - place: {ball: cue, spot: [3, 0]}\n"
              "      |                        ^~~~\n");
    EXPECT_EQ(problems_of("balls: {cue: {at: [0, 0]}}\n"
                          "events:\n"
                          "  - place: {ball: cue, spot: [0, 0.5]}\n"
                          "respot: pool\n"),
              "t.yaml:6:9: error: 'respot' must be one of snooker, eight_ball, nine_ball and "
              "carom, not 'pool'\n"
              "    6 | respot: pool\n"
              "      |         ^~~~\n");
    EXPECT_EQ(problems_of("balls: {cue: {at: [0, 0]}}\nrespot: nine_ball\n"),
              "t.yaml:4:1: error: respot needs a table with cushions\n"
              "    4 | respot: nine_ball\n"
              "      | ^~~~~~\n");
}

TEST(PlaceEvent, WithoutATable_IsRefused) {
    EXPECT_EQ(problems_of("balls: {cue: {at: [0, 0]}}\n"
                          "events:\n"
                          "  - place: {ball: cue, spot: [0, 0.5]}\n"
                          "  - remove: {ball: cue}\n"),
              "t.yaml:5:24: error: event 1 on 'cue': without a table a ball has no place\n"
              "    5 |   - place: {ball: cue, spot: [0, 0.5]}\n"
              "      |                        ^~~~\n"
              "t.yaml:6:5: error: event 2 on 'cue': without a table a ball cannot be taken off\n"
              "    6 |   - remove: {ball: cue}\n"
              "      |     ^~~~~~\n");
}

TEST(Spots, AreOfferedByTheCompletion) {
    const auto offered = [](const std::string& start, const std::string& table) {
        const config::Node tree = config::readable_tree(
            "carom: 1\n" + table + "balls: {cue: {at: [0, 0]}}\n", "/nowhere/t.yaml");
        std::vector<std::string> all;
        for (const config::KeyCandidate& candidate : config::complete_override(start, tree)) {
            all.push_back(candidate.text);
        }
        return all;
    };
    EXPECT_THAT(
        offered("balls.cue.at=", "table: {kind: pool}\n"),
        testing::ElementsAre("balls.cue.at=foot", "balls.cue.at=head", "balls.cue.at=centre"));
    EXPECT_THAT(
        offered("balls.cue.at=b", "table: {kind: snooker}\n"),
        testing::ElementsAre("balls.cue.at=brown", "balls.cue.at=blue", "balls.cue.at=black"));
}

TEST(Rack, AtOfASnookerRack_IsRefused) {
    EXPECT_EQ(problems_of("table: {kind: snooker}\nrack: {set: snooker, at: blue}\n"),
              "t.yaml:4:22: error: 'at' has no meaning for a snooker or carom rack, whose balls "
              "have spots of their own\n"
              "    4 | rack: {set: snooker, at: blue}\n"
              "      |                      ^~\n");
}

}  // namespace
}  // namespace carom::pipeline
