// Moments as scene times: how they are read, and what they become once the motion is known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "load.h"
#include "pipeline/config/explain.h"
#include "pipeline/config/parse_moment.h"
#include "sim/bake.h"

namespace carom::pipeline {
namespace {

using ::testing::HasSubstr;

std::string shot_with(const std::string& camera, const std::string& event = "") {
    return R"(carom: 1
simulation: {duration: 14 s}
table: {kind: carom}
balls: {cue: {at: [-0.5, 0]}, one: {at: [0.4, 0.01]}, two: {at: [-0.5, 0.4]}}
events:
  - strike: {ball: cue, at: 0.25 s, toward: one, speed: 3}
)" + event +
           R"(cameras:
  - video: [0 s, 2 s]
    position: [0, -2, 1]
    target: [0, 0, 0]
)" + camera;
}

struct Resolved {
    LoadResult loaded;
    sim::Timeline timeline;
    std::vector<Problem> problems;
};

/// The shot with the times of its moments.
Resolved resolve(const std::string& text) {
    Resolved result{load_shot_text(text, "s.yaml"), {}, {}};
    EXPECT_EQ(all_problems(result.loaded), "");
    if (result.loaded.shot) {
        result.timeline = sim::bake(result.loaded.shot->world);
        result.problems =
            resolve_moments(*result.loaded.shot, result.loaded.source, result.timeline);
    }
    return result;
}

double time_of(const Resolved& resolved, const std::string& moment) {
    const auto parsed = parse_moment(moment);
    const auto found = sim::find_event_time(std::get<sim::EventTime>(parsed), resolved.timeline,
                                            resolved.loaded.shot->world);
    return std::get<double>(found);
}

TEST(Moments, InACamera_BecomeTimes) {
    const Resolved resolved = resolve(shot_with(
        "    scene: [{strike: cue, before: 0.2 s}, {cushion: one, nth: 2, after: 50 ms}]\n"));
    ASSERT_TRUE(resolved.problems.empty());
    const TimeMap& map = resolved.loaded.shot->cameras[0].time_map;
    EXPECT_EQ(map.scene_start, Rational(5, 100));
    EXPECT_NEAR(map.scene_end.to_double(), time_of(resolved, "{cushion: one, nth: 2}") + 0.05,
                1e-6);
    const std::vector<ShotMoment>& moments = resolved.loaded.shot->moments;
    ASSERT_EQ(moments.size(), 2U);
    EXPECT_EQ(moments[0], (ShotMoment{"cameras[0].scene[0]", 0.05}));
    EXPECT_EQ(moments[1].key_path, "cameras[0].scene[1]");
}

TEST(Moments, AsOneTime_FreezeIt) {
    const Resolved resolved = resolve(shot_with("    scene: {contact: [one, cue]}\n"));
    const TimeMap& map = resolved.loaded.shot->cameras[0].time_map;
    EXPECT_EQ(map.scene_start, map.scene_end);
    EXPECT_NEAR(map.scene_start.to_double(), time_of(resolved, "{contact: [cue, one]}"), 1e-6);
}

TEST(Moments, StandWhereverASceneTimeDoes) {
    const Resolved resolved = resolve(R"(carom: 1
simulation: {duration: 14 s}
table: {kind: carom}
balls: {cue: {at: [-0.5, 0]}, one: {at: [0.4, 0.01]}}
events:
  - strike: {ball: cue, at: 0.25 s, toward: one, speed: 3}
cameras:
  - video: [0 s, 2 s]
    scene: {from: {contact: [cue, one], before: 0.1 s}, speeds: [[0 s, 1], [2 s, 1/8]]}
    position: {bezier: [[0, -2, 1], {of: cue, at: {resting: cue}, offset: [0, -1, 1]}]}
    target: {along: cue, from: {strike: cue}, to: {contact: [cue, one]}}
)");
    ASSERT_TRUE(resolved.problems.empty());
    const CameraRig& rig = resolved.loaded.shot->cameras[0];
    const double contact = time_of(resolved, "{contact: [cue, one]}");
    EXPECT_NEAR(rig.time_map.scene_start.to_double(), contact - 0.1, 1e-6);
    EXPECT_NEAR(std::get<BezierPath>(rig.position).points[1].at,
                time_of(resolved, "{resting: cue}"), 1e-6);
    EXPECT_NEAR(std::get<AlongPath>(rig.target).from, 0.25, 1e-6);
    EXPECT_NEAR(std::get<AlongPath>(rig.target).to, contact, 1e-6);
}

TEST(Moments, InTheExplainedShot_AreTimesWithTheirOrigin) {
    const Resolved resolved =
        resolve(shot_with("    scene: [{strike: cue, before: 0.2 s}, 1 s]\n"));
    const std::string text = explained_yaml(*resolved.loaded.source, *resolved.loaded.shot);
    EXPECT_THAT(text, HasSubstr("\"0.05 s\""));
    EXPECT_THAT(resolved.loaded.shot->resolved_text, HasSubstr("scene: [\"0.05 s\", 1 s]"));
    // The bake keeps the moment, so that it can be filmed again after the shot changed.
    EXPECT_THAT(load(shot_with("    scene: [{strike: cue}, 1 s]\n")).resolved_text,
                HasSubstr("scene: [{strike: cue}, 1 s]"));
}

TEST(Moments, BeforeTheMotionIsKnown_AreOpen) {
    const Shot shot = load(shot_with("    scene: [{strike: cue}, 1 s]\n"));
    EXPECT_TRUE(has_open_moments(shot));
    ASSERT_EQ(shot.moments.size(), 1U);
    EXPECT_FALSE(shot.moments[0].time);
    EXPECT_FALSE(has_open_moments(load(shot_with("    scene: [0 s, 1 s]\n"))));
}

TEST(Moments, ThatNeverCome_AreErrorsAtTheirPlace) {
    Resolved resolved = resolve(shot_with("    scene: [{contact: [two, one]}, {apex: cue}]\n"));
    EXPECT_TRUE(has_open_moments(*resolved.loaded.shot));
    std::string text;
    for (const Problem& problem : resolved.problems) {
        text += format(problem);
    }
    EXPECT_EQ(
        text,
        R"(s.yaml:11:13: error: this moment never comes: 'two' never touched 'one'; it touched nothing
   11 |     scene: [{contact: [two, one]}, {apex: cue}]
      |             ^
s.yaml:11:36: error: this moment never comes: 'cue' never rose by 1 mm or more
   11 |     scene: [{contact: [two, one]}, {apex: cue}]
      |                                    ^
)");
}

TEST(Moments, BeforeTheShotBegins_AreErrors) {
    const Resolved resolved =
        resolve(shot_with("    scene: [{strike: cue, before: 1.5 s}, 1 s]\n"));
    ASSERT_EQ(resolved.problems.size(), 1U);
    EXPECT_EQ(resolved.problems[0].message, "this moment is 1.25 s before the shot begins");
}

TEST(Moments, WithWrongKeys_AreErrors) {
    const auto problem = [](const std::string& moment) {
        return first_problem(shot_with("    scene: [" + moment + ", 1 s]\n"));
    };
    EXPECT_EQ(problem("{nth: 2}"),
              "'scene' of camera 1 needs one of 'contact', 'cushion', 'potted', 'resting', "
              "'crossing', 'strike' or 'apex'");
    EXPECT_EQ(problem("{contact: [cue, one], before: 1 s, after: 1 s}"),
              "'after' contradicts 'before' in 'scene' of camera 1; give only one of them");
    EXPECT_EQ(problem("{contact: [cloth, cushion]}"),
              "'cloth' and 'cushion' are parts of the table; one of the two has to be an object");
    EXPECT_EQ(problem("{cushion: cue, nth: 0}"),
              "'nth' must be at least 1 and at most 100000, not '0'");
    EXPECT_EQ(problem("{cushion: seven}"), "there is no ball or object 'seven'");
    EXPECT_EQ(problem("{strike: table}"), "there is no ball 'table'");
    EXPECT_EQ(problem("[1 s]"), "'scene[0]' must be a time (s, ms, min), not a list");
}

TEST(Conditions, TakeTheKindsOfMoments) {
    const Shot shot = load(shot_with(
        "    scene: [0 s, 1 s]\n",
        "  - impulse: {object: two, when: {cushion: one, nth: 2, after: 0.1 s}, after: 0.2 s, "
        "newton_seconds: [0, 0.1, 0]}\n"));
    const sim::ForceEvent& event = shot.world.events[1];
    ASSERT_TRUE(event.trigger);
    EXPECT_EQ(event.trigger->kind, sim::Trigger::Kind::contact);
    EXPECT_EQ(event.trigger->a, "one");
    EXPECT_EQ(event.trigger->b, "cushion");
    EXPECT_EQ(event.trigger->nth, 2);
    EXPECT_NEAR(event.after, 0.3, 1e-15);
    EXPECT_TRUE(shot.moments.empty());
}

TEST(Conditions, RefuseAnEffectAheadOfItsCause) {
    EXPECT_EQ(first_problem(shot_with("    scene: [0 s, 1 s]\n",
                                      "  - impulse: {object: two, when: {cushion: one, before: 1 "
                                      "s}, newton_seconds: [0, 1, 0]}\n")),
              "'before' in 'when' of 'impulse' of event 2 asks for an effect ahead of its cause: "
              "the event "
              "cannot happen before what it waits for");
}

TEST(ParseMoment, ReadsAnOption) {
    const auto moment =
        std::get<sim::EventTime>(parse_moment("{apex: cue, nth: 3, before: 50 ms}"));
    EXPECT_EQ(moment.trigger.kind, sim::Trigger::Kind::apex);
    EXPECT_EQ(moment.trigger.nth, 3);
    EXPECT_EQ(moment.delay, -0.05);
    EXPECT_EQ(std::get<std::string>(parse_moment("{apx: cue}")),
              "unknown key 'apx' in the moment (did you mean 'apex'?)");
    EXPECT_THAT(std::get<std::string>(parse_moment("{apex: ")), HasSubstr("YAML syntax"));
}

}  // namespace
}  // namespace carom::pipeline
