// Triggers that fire when a body crosses a line.
#include <cmath>

#include <gtest/gtest.h>

#include "shots.h"

namespace carom::sim::test {
namespace {

/// Pushes `marker` when `object` crosses the line.
ForceEvent when_crossing(const std::string& object, const Vec2& from, const Vec2& to,
                         double time = 0, double after = 0) {
    ForceEvent event;
    event.object = "marker";
    event.time = time;
    event.after = after;
    event.action = Impulse{{0, 0.01, 0}, {0, 0, 0}, Axes::world};
    Trigger trigger;
    trigger.kind = Trigger::Kind::crossing;
    trigger.a = object;
    trigger.from = from;
    trigger.to = to;
    event.trigger = trigger;
    return event;
}

WorldDescription world_of(const Body& body, double duration, const ForceEvent& event) {
    WorldDescription world = cloth_world(duration);
    world.bodies = {body, ball("marker", 0, 50)};
    world.events = {event};
    return world;
}

/// Time at which the marker was pushed; -1 if it never was.
double push_time(const WorldDescription& world) {
    const Timeline timeline = bake(world);
    const Event* impulse = find_event(timeline, EventKind::impulse, "marker");
    return impulse != nullptr ? impulse->time : -1;
}

Body rolling(double x, double y, const Vec3& velocity) {
    return ball("cue", x, y, velocity, rolling_spin(velocity));
}

TEST(Crossing_ByARollingBall, IsWhenItsCentreIsOnTheLine) {
    // x = 2 t - mu g t^2 / 2 reaches 1.
    const double a = 0.01 * kGravity;
    const double expected = (2 - std::sqrt(4 - 2 * a)) / a;
    for (const double after : {0.0, 0.25}) {
        const ForceEvent event = when_crossing("cue", {1, -0.5}, {1, 0.5}, 0, after);
        EXPECT_NEAR(push_time(world_of(rolling(0, 0, {2, 0, 0}), 2, event)), expected + after,
                    1e-13);
    }
    // With the ends of the line exchanged, and from the other side.
    EXPECT_NEAR(push_time(world_of(rolling(2, 0, {-2, 0, 0}), 2,
                                   when_crossing("cue", {1, 0.5}, {1, -0.5}))),
                expected, 1e-13);
}

TEST(Crossing_BesideTheSegment, DoesNotCount) {
    const ForceEvent event = when_crossing("cue", {1, 0.1}, {1, 0.5});
    const WorldDescription world = world_of(rolling(0, 0, {2, 0, 0}), 2, event);
    const Timeline result = bake(world);
    EXPECT_EQ(find_event(result, EventKind::impulse, "marker"), nullptr);
    ASSERT_EQ(result.warnings.size(), 1U);
    EXPECT_EQ(result.warnings[0].sentence,
              "event 1 on 'marker' never happened: 'cue' never crossed the line");
}

TEST(Crossing_BeforeItsTime, DoesNotCount) {
    // The ball crosses the line at 0.1 s, and again after the cushion.
    WorldDescription world = walled_world(4);
    world.contact_law.ball_cushion = {CushionModel::mirror, 1, 0};
    world.contact_law.ball_cloth = {0, 0, 0, 0.5};
    world.bodies = {ball("cue", 0.5, 0, {1, 0, 0}), ball("marker", -1, 0.5)};
    world.events = {when_crossing("cue", {0.6, -0.1}, {0.6, 0.1})};
    EXPECT_NEAR(push_time(world), 0.1, 1e-13);
    world.events[0].time = 0.3;
    const double turn = 1.27 - kRadius;
    EXPECT_NEAR(push_time(world), (turn - 0.5) + (turn - 0.6), 1e-12);
}

TEST(Crossing_ByABallThatStartsOnTheLine, IsNotItsDeparture) {
    // The ball leaves the line on which it starts and returns to it by draw.
    WorldDescription world = world_of(ball("cue", 0, 0, {1, 0, 0}, {0, -150, 0}), 3,
                                      when_crossing("cue", {0, -1}, {0, 1}));
    const Timeline timeline = bake(world);
    const Event* impulse = find_event(timeline, EventKind::impulse, "marker");
    ASSERT_NE(impulse, nullptr);
    EXPECT_GT(impulse->time, 0.3);
    EXPECT_NEAR(state_at(timeline, "cue", impulse->time).position.x, 0, 1e-6);
    EXPECT_LT(state_at(timeline, "cue", impulse->time).velocity.x, 0);
    world.bodies[0].angular_velocity = {0, 0, 0};
    EXPECT_EQ(push_time(world), -1);
}

TEST(Crossing_InTheAir, IsSeenFromAbove) {
    Body thrown = ball("cue", 0, 0, {1.5, 0, 3});
    thrown.pose.position.z = 0.4;
    EXPECT_NEAR(push_time(world_of(thrown, 1, when_crossing("cue", {0.6, -1}, {0.6, 1}))), 0.4,
                1e-13);
}

TEST(Crossing_AtAnImpact, IsFoundOnce) {
    // The balls collide when the cue ball's centre is on the line (up to rounding); then it
    // continues.
    WorldDescription world =
        world_of(rolling(0, 0, {2, 0, 0}), 2, when_crossing("cue", {0.5, -1}, {0.5, 1}));
    world.bodies.push_back(ball("one", 0.5 + 2 * kRadius, 0));
    world.contact_law.ball_ball.restitution = 0.5;
    const Timeline timeline = bake(world);
    EXPECT_EQ(count_events(timeline, EventKind::impulse), 1);
    EXPECT_NEAR(find_event(timeline, EventKind::impulse, "marker")->time,
                find_event(timeline, EventKind::impact, "cue", "one")->time, 1e-9);
}

TEST(Crossing_ByABodyInOde, IsOnItsPath) {
    // A box slides; v = 1 - mu g t, x = t - mu g t^2 / 2 reaches 0.1.
    WorldDescription world = cloth_world(1);
    Body box = ball("box", 0, 0, {1, 0, 0});
    box.shape = Box{{0.1, 0.1, 0.02}};
    box.material = "wood";
    box.pose.position.z = 0.01;
    world.contact_law.pairs[{"cloth", "wood"}] = {0, 0.3, 0};
    world.bodies = {box, ball("marker", 0, 50)};
    world.events = {when_crossing("box", {0.1, -1}, {0.1, 1})};
    const Timeline timeline = bake(world);
    const Event* impulse = find_event(timeline, EventKind::impulse, "marker");
    ASSERT_NE(impulse, nullptr);
    const double a = 0.3 * kGravity;
    EXPECT_NEAR(impulse->time, (1 - std::sqrt(1 - 0.2 * a)) / a, 2e-4);
    EXPECT_NEAR(state_at(timeline, "box", impulse->time).position.x, 0.1, 1e-6);
}

TEST(Crossing_ByABallOnTheEdgeOfAPocket, IsOnItsPath) {
    WorldDescription world = nine_ball_world(3);
    const billiards::Pocket pocket = billiards::build_table(*world.table, kRadius).pockets[0];
    const Vec2 outward = Vec2(-1, -1).normalized();
    const Vec2 start = pocket.centre - outward * (pocket.radius + 0.02);
    world.bodies = {rolling(start.x, start.y, Vec3(outward.x, outward.y, 0) * 0.1),
                    ball("marker", 0, 0)};
    // The line is perpendicular to the path, a centimetre beyond the edge, where ODE steps the
    // ball.
    const Vec2 place = pocket.centre - outward * (pocket.radius - 0.01);
    const Vec2 across(-outward.y, outward.x);
    world.events = {when_crossing("cue", place - across * 0.05, place + across * 0.05)};
    const Timeline timeline = bake(world);
    const Event* impulse = find_event(timeline, EventKind::impulse, "marker");
    ASSERT_NE(impulse, nullptr);
    const Vec3 p = state_at(timeline, "cue", impulse->time).position;
    EXPECT_NEAR((Vec2(p.x, p.y) - place).dot(outward), 0, 2e-6);
    EXPECT_LT(p.z, kRadius - 1e-4);
}

TEST(Trigger_Potted, FiresAfterTheBallHasFallen) {
    WorldDescription world = nine_ball_world(2);
    const billiards::Pocket pocket = billiards::build_table(*world.table, kRadius).pockets[1];
    world.bodies = {ball("one", pocket.centre.x, pocket.centre.y), ball("marker", 0.5, 0)};
    for (const double after : {0.0, 0.2}) {
        ForceEvent event = when_crossing("one", {0, 0}, {1, 0}, 0, after);
        event.trigger = Trigger{Trigger::Kind::potted, "one", "", {0, 0}, {0, 0}};
        world.events = {event};
        const Timeline timeline = bake(world);
        const Event* potted = find_event(timeline, EventKind::potted, "one");
        const Event* impulse = find_event(timeline, EventKind::impulse, "marker");
        ASSERT_NE(potted, nullptr);
        ASSERT_NE(impulse, nullptr);
        EXPECT_NEAR(impulse->time, potted->time + after, 1e-12);
    }
    // The event's time is after the potting, so it never happens.
    world.events[0].time = 1;
    EXPECT_EQ(bake(world).warnings.at(0).sentence,
              "event 1 on 'marker' never happened: 'one' was never potted");
}

TEST(Crossing_WithAnInvalidLine, IsAProblem) {
    const WorldDescription world =
        world_of(rolling(0, 0, {1, 0, 0}), 1, when_crossing("cue", {1, 1}, {1, 1}));
    EXPECT_EQ(problem_sentences(world).at(0),
              "event 1 on 'marker': the line of its trigger needs two different ends");
    WorldDescription still =
        world_of(rolling(0, 0, {1, 0, 0}), 1, when_crossing("cue", {1, 0}, {1, 1}));
    still.bodies[0].kind = BodyKind::fixed;
    EXPECT_EQ(problem_sentences(still).at(0),
              "event 1 on 'marker': it waits for 'cue' to cross a line, but that body is fixed");
}

}  // namespace
}  // namespace carom::sim::test
