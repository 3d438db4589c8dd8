// Tests of the places of problems that the simulation or the renderer reports.
#include <string>

#include <gtest/gtest.h>

#include "pipeline/config/load_shot.h"
#include "pipeline/config/shot_source.h"

namespace carom::pipeline {
namespace {

using Kind = Subject::Kind;

constexpr const char* kShot = R"(carom: 1
simulation: {duration: 2 s}
physics: {ball_ball: {restitution: 0.95}}
table: {kind: pool, size: 9 ft, pockets: {corner: {drop: 10 cm}}}
rack: {set: nine_ball}
balls:
  cue: {at: [-0.7, 0.1], mass: 170 g}
objects:
  crate: {box: [0.1, 0.1, 0.1], at: [3, 0, 0], physics: {mass: 1 kg}}
lights:
  lamp: {sphere: 10 cm, at: [0, 0, 2], radiance: 10}
events:
  - impulse: {object: cue, newton_seconds: [0, 0.1, 0]}
  - strike: {ball: cue, toward: one, speed: 2, tip: [0, 0.3]}
render: {samples: 4}
cameras:
  - {video: [0 s, 1 s], scene: [0 s, 1 s], position: [0, -3, 2], target: [0, 0, 0]}
)";

/// "line:column key"; "nowhere" if the problem refers to the whole shot.
std::string place_of(const Subject& subject, const std::string& field) {
    static const LoadResult loaded = load_shot_text(kShot, "shot.yaml");
    if (!loaded.source) {
        return loaded.problems.empty() ? "no source" : loaded.problems.front().message;
    }
    const Problem problem =
        loaded.source->problem_of({subject, field, "a sentence", Severity::warning});
    EXPECT_EQ(problem.severity, Severity::warning);
    EXPECT_EQ(problem.message, "a sentence");
    return problem.place.file.empty()
               ? "nowhere"
               : std::to_string(problem.place.line) + ":" + std::to_string(problem.place.column) +
                     " " + problem.key_path;
}

TEST(DiagnosticPlace, Event_IsFoundByItsIndexAndField) {
    EXPECT_EQ(place_of(Subject::event(1), "tip"), "14:48 events[1].strike.tip");
    EXPECT_EQ(place_of(Subject::event(0), "when"), "13:5 events[0].impulse");
    EXPECT_EQ(place_of(Subject::event(7), "tip"), "12:1 events");
}

TEST(DiagnosticPlace, Body_IsABallAnObjectOrTheRack) {
    EXPECT_EQ(place_of(Subject::body("cue"), "mass"), "7:26 balls.cue.mass");
    EXPECT_EQ(place_of(Subject::body("cue"), ""), "7:3 balls.cue");
    EXPECT_EQ(place_of(Subject::body("crate"), "at"), "9:33 objects.crate.at");
    EXPECT_EQ(place_of(Subject::body("nine"), "at"), "5:1 rack");
}

TEST(DiagnosticPlace, TableWithoutTheDimension_IsItsKind) {
    EXPECT_EQ(place_of({Kind::table}, "pockets.corner.drop"), "4:52 table.pockets.corner.drop");
    EXPECT_EQ(place_of({Kind::table}, "pockets.side.mouth"), "4:33 table.pockets");
    EXPECT_EQ(place_of({Kind::table}, "length"), "4:9 table.kind");
}

TEST(DiagnosticPlace, World_HasFieldsInTwoSections) {
    EXPECT_EQ(place_of({}, "duration"), "2:14 simulation.duration");
    EXPECT_EQ(place_of({}, "gravity"), "3:1 physics");
    EXPECT_EQ(place_of({Kind::contact, "ball_ball"}, "restitution"),
              "3:23 physics.ball_ball.restitution");
    EXPECT_EQ(place_of({}, ""), "nowhere");
}

TEST(DiagnosticPlace, Look_IsFoundByName) {
    EXPECT_EQ(place_of({Kind::light, "lamp"}, "sphere"), "11:10 lights.lamp.sphere");
    EXPECT_EQ(place_of({Kind::settings}, "samples"), "15:10 render.samples");
}

}  // namespace
}  // namespace carom::pipeline
