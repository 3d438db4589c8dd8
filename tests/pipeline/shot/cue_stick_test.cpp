// The cue stick that is seen to strike: it is where the strike says when the strike happens, and
// touches nothing else.
#include "pipeline/shot/cue_stick.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/rigid.h"
#include "sim/bake.h"

namespace carom::pipeline {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kDegree = 0.017453292519943295;

sim::Body ball(const std::string& name, double x, double y) {
    sim::Body body;
    body.name = name;
    body.shape = sim::Sphere{kRadius};
    body.pose.position = {x, y, kRadius};
    return body;
}

sim::ForceEvent strike(const std::string& name, double time, double direction, double speed,
                       double elevation, Vec2 tip = {0, 0}) {
    sim::ForceEvent event;
    event.object = name;
    event.time = time;
    sim::Strike action;
    action.direction = direction;
    action.speed = speed;
    action.elevation = elevation;
    action.tip = tip;
    event.action = action;
    return event;
}

struct Played {
    sim::WorldDescription world;
    sim::Timeline timeline;
    ShownStick stick;

    [[nodiscard]] sim::Track track() const { return stick_motion(stick, world, timeline); }
};

Played play(std::vector<sim::Body> bodies, std::vector<sim::ForceEvent> events,
            double duration = 8) {
    Played played;
    played.world.duration = duration;
    played.world.table = sim::billiards::standard_table(sim::billiards::TableKind::pool, "9 ft");
    played.world.bodies = std::move(bodies);
    played.world.events = std::move(events);
    for (std::size_t i = 0; i < played.world.events.size(); ++i) {
        played.stick.events.push_back(i);
    }
    played.timeline = sim::bake(played.world);
    return played;
}

/// The stick's axis: from the front of the tip towards the butt.
Vec3 axis_of(const MotionState& state) {
    return to_world(state.orientation, Vec3(0, 0, 1));
}

TEST(CueStick, AtTheContact_TouchesTheBallWithTheSpeedOfTheStrike) {
    const Vec2 tip(0.2, -0.3);
    const Played played =
        play({ball("cue", 0.2, 0.1)}, {strike("cue", 3, 0.4, 2.5, 6 * kDegree, tip)});
    const sim::Track track = played.track();
    const MotionState at = track.sample(3);
    const Vec3 axis = axis_of(at);
    EXPECT_NEAR(axis.z, std::sin(6 * kDegree), 1e-9);
    EXPECT_NEAR(std::atan2(-axis.y, -axis.x), 0.4, 1e-9);
    // The dome of the tip, a sphere of 9 mm, touches the ball at the offset.
    const Vec3 dome = at.position + axis * 0.009;
    const Vec3 offset = dome - Vec3(0.2, 0.1, kRadius);
    EXPECT_NEAR(offset.length(), kRadius + 0.009, 1e-9);
    const Vec3 right(std::sin(0.4), -std::cos(0.4), 0);
    EXPECT_NEAR(offset.normalized().dot(right), tip.x, 1e-9);
    EXPECT_NEAR(offset.normalized().dot(right.cross(-axis)), tip.y, 1e-9);
    const Vec3 before = track.sample(3 - 1e-9).velocity;
    EXPECT_NEAR(before.length(), 2.5, 1e-3);
    EXPECT_NEAR(before.normalized().dot(-axis), 1, 1e-9);
    const double after = track.sample(3 + 2e-5).velocity.length();
    EXPECT_LT(after, 2);
    EXPECT_GT(after, 0.5);
}

TEST(CueStick, BeforeAStrike_MakesAsManyWarmUpsAsThereIsTime) {
    const auto warm_ups = [](double time) {
        const Played played =
            play({ball("cue", 0, 0)}, {strike("cue", time, 0, 2, 6 * kDegree)}, 20);
        const sim::Track track = played.track();
        int turns = 0;  // at which the stick begins to go forwards
        double last = 0;
        for (double t = 0; t < time; t += 1e-3) {
            const double forward = track.sample(t).velocity.dot(-axis_of(track.sample(t)));
            turns += last < -1e-6 && forward > 1e-6 ? 1 : 0;
            last = std::abs(forward) > 1e-6 ? forward : last;
        }
        return turns - 1;  // the last one is the stroke itself
    };
    const StrokeHabit habit;
    const double stroke =
        2 * (0.06 + 0.045 * 2) / 2 + habit.back_pause + habit.back_swing_time + habit.address_pause;
    EXPECT_EQ(warm_ups(stroke + 0.9 * habit.warm_up_time), 0);
    EXPECT_EQ(warm_ups(stroke + 1.1 * habit.warm_up_time), 1);
    EXPECT_EQ(warm_ups(stroke + 3.1 * habit.warm_up_time), 3);
    EXPECT_EQ(warm_ups(stroke + 12 * habit.warm_up_time), habit.most_warm_ups);
}

TEST(CueStick, InPlay_TouchesNoBallButTheStruckOneAtTheContact) {
    // A follow shot at a ball close ahead, then a steep stroke over another ball.
    Played played = play(
        {ball("cue", 0, 0), ball("one", 0.12, 0), ball("two", -0.2, 0.3)},
        {strike("cue", 2, 0, 2, 5 * kDegree, {0, 0.3}), strike("two", 7, 1.6, 1.5, 30 * kDegree)},
        10);
    const sim::Track track = played.track();
    for (double time = 0; time <= 10; time += 2e-3) {
        const MotionState state = track.sample(time);
        const Vec3 axis = axis_of(state);
        for (const std::string name : {"cue", "one", "two"}) {
            const Vec3 offset = played.timeline.find(name)->sample(time).position - state.position;
            const double along = std::clamp(offset.dot(axis), 0.009, played.stick.length);
            const double distance = (offset - axis * along).length();
            EXPECT_GT(distance, kRadius + 0.006) << name << " at " << time;
        }
        EXPECT_GT(state.position.z, 0.5 * played.stick.tip_diameter) << time;
    }
}

TEST(CueStick, ThatFollowsTooSoon_IsNotShown) {
    const Played played =
        play({ball("cue", 0, 0), ball("one", 0, 0.4)},
             {strike("cue", 2, 0, 2, 6 * kDegree), strike("one", 2.5, 0, 2, 6 * kDegree)});
    EXPECT_EQ(shown_strikes(played.stick, played.world, played.timeline).size(), 1U);
    const auto problems = stick_problems(played.stick, played.world, played.timeline);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].sentence,
              "the stick that strikes 'one' at 2.5 s is not shown: it cannot be back in time from "
              "the strike before");
    EXPECT_EQ(problems[0].severity, Severity::warning);
}

TEST(CueStick, ThroughTheRail_IsWarnedOfWithTheLeastElevation) {
    // The ball is 0.3 m in front of the end rail, whose top is higher than a level stick.
    const auto problem = [](double elevation) {
        const Played played = play({ball("cue", -0.97, 0)}, {strike("cue", 2, 0, 2, elevation)});
        const auto problems = stick_problems(played.stick, played.world, played.timeline);
        return problems.empty() ? std::string() : problems[0].sentence;
    };
    const std::string level = problem(0);
    const std::string begin =
        "the stick that strikes 'cue' at 2 s passes through the rail; an "
        "elevation of at least ";
    ASSERT_EQ(level.substr(0, begin.size()), begin);
    const double least = std::stod(level.substr(begin.size()));
    // The axis has to be 40 mm + the stick's radius high at 0.3 m behind the ball, or at its end.
    EXPECT_GT(least, 3);
    EXPECT_LT(least, 6);
    EXPECT_EQ(problem(least * kDegree), "");
    EXPECT_NE(problem((least - 0.2) * kDegree), "");
}

TEST(CueStick, OverABall_IsWarnedOf) {
    const Played played =
        play({ball("cue", 0, 0), ball("one", -0.2, 0)}, {strike("cue", 2, 0, 2, 4 * kDegree)});
    const auto problems = stick_problems(played.stick, played.world, played.timeline);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].sentence.substr(0, 60),
              "the stick that strikes 'cue' at 2 s passes through 'one'; an");
}

}  // namespace
}  // namespace carom::pipeline
