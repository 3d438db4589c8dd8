// Force events and triggers.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "shots.h"

namespace carom::sim::test {
namespace {

ForceEvent event_on(const std::string& object, double time, decltype(ForceEvent::action) action) {
    ForceEvent event;
    event.object = object;
    event.time = time;
    event.action = std::move(action);
    return event;
}

TEST(Impulse_ThroughTheCentre, GivesItsVelocity) {
    WorldDescription world = cloth_world(1);
    world.bodies = {ball("cue", 0, 0)};
    world.events = {event_on("cue", 0.25, Impulse{{0.3, 0, 0}, {0, 0, 0}, Axes::world})};
    const Timeline timeline = bake(world);
    EXPECT_EQ(state_at(timeline, "cue", 0.24).velocity, Vec3(0, 0, 0));
    EXPECT_NEAR(key_at(timeline, "cue", 0.25).velocity_out.x, 0.3 / kMass, 1e-12);
    const Event* logged = find_event(timeline, EventKind::impulse, "cue");
    ASSERT_NE(logged, nullptr);
    EXPECT_EQ(logged->vector, Vec3(0.3, 0, 0));
    EXPECT_EQ(logged->time, 0.25);
}

TEST(Impulse_AtSevenFifthsOfTheRadius, RollsImmediately) {
    WorldDescription world = cloth_world(1);
    world.bodies = {ball("cue", 0, 0)};
    world.events = {event_on("cue", 0, Impulse{{0.2, 0, 0}, {0, 0, 0.4 * kRadius}, Axes::world})};
    const Timeline timeline = bake(world);
    EXPECT_NE(find_event(timeline, EventKind::rolling, "cue"), nullptr);
    EXPECT_EQ(find_event(timeline, EventKind::sliding, "cue"), nullptr);
}

TEST(Force_OverAnyDuration, GivesItsImpulseExactly) {
    for (const double duration : {0.00031, 0.0123, 0.2}) {
        WorldDescription world = cloth_world(1);
        world.contact_law.ball_cloth = {0, 0, 0, 0.5};
        world.bodies = {ball("cue", 0, 0)};
        world.events = {event_on("cue", 0.1, Force{{2, -1, 0}, duration, {0, 0, 0}, Axes::world})};
        const Timeline timeline = bake(world);
        const Vec3 expected = Vec3(2, -1, 0) * (duration / kMass);
        EXPECT_NEAR((state_at(timeline, "cue", 1).velocity - expected).length(), 0, 1e-12);
        const Event* logged = find_event(timeline, EventKind::force, "cue");
        EXPECT_NEAR(logged->end_time - logged->time, duration, 1e-15);
        // The position is that of a uniform acceleration.
        const double t = 0.9 - duration;
        EXPECT_NEAR(state_at(timeline, "cue", 1).position.x, expected.x * (duration / 2 + t), 1e-9);
    }
}

TEST(Force_PushingARollingBall, AcceleratesItByFiveSevenths) {
    WorldDescription world = cloth_world(1);
    world.contact_law.ball_cloth.rolling_friction = 0;
    world.bodies = {ball("cue", 0, 0)};
    const double newtons = 0.1;
    world.events = {event_on("cue", 0, Force{{newtons, 0, 0}, 1, {0, 0, 0}, Axes::world})};
    const double expected = 5.0 / 7 * newtons / kMass;
    EXPECT_NEAR(state_at(bake(world), "cue", 1).velocity.x, expected, 1e-3 * expected);
}

std::vector<EventKind> kinds_of(const Timeline& timeline, const std::string& object) {
    std::vector<EventKind> kinds;
    for (const Event& event : timeline.events) {
        if (event.a == object) {
            kinds.push_back(event.kind);
        }
    }
    return kinds;
}

/// After each of the four hundred impulses the ball slides for a moment and then rolls again.
TEST(Force_OnARollingBall, LeavesItRollingInTheLog) {
    WorldDescription world = cloth_world(3);
    world.bodies = {ball("cue", 0, 0), ball("one", 0, 1, {1, 0, 0})};
    world.events = {event_on("cue", 0.5, Force{{0.5, 0, 0}, 0.2, {0, 0, 0}, Axes::world}),
                    event_on("one", 1, Torque{{0, 0.01, 0}, 0.2, Axes::world})};
    const Timeline timeline = bake(world);
    EXPECT_EQ(kinds_of(timeline, "cue"),
              (std::vector<EventKind>{EventKind::force, EventKind::rolling}));
    EXPECT_EQ(kinds_of(timeline, "one"),
              (std::vector<EventKind>{EventKind::rolling, EventKind::torque}));
}

TEST(Force_ThatIsStrong, MakesTheBallSlideUntilItEnds) {
    WorldDescription world = cloth_world(2);
    world.bodies = {ball("cue", 0, 0)};
    world.events = {event_on("cue", 0.5, Force{{10, 0, 0}, 0.1, {0, 0, 0}, Axes::world})};
    const Timeline timeline = bake(world);
    EXPECT_EQ(kinds_of(timeline, "cue"),
              (std::vector<EventKind>{EventKind::force, EventKind::sliding, EventKind::rolling}));
    EXPECT_GT(find_event(timeline, EventKind::rolling, "cue")->time, 0.6);
}

/// A slab of 0.1 m with a ball on it.
WorldDescription ball_on_a_slab() {
    WorldDescription world = cloth_world(3);
    Body slab;
    slab.name = "slab";
    slab.shape = Box{{1, 0.4, 0.1}};
    slab.material = "wood";
    slab.kind = BodyKind::fixed;
    slab.pose.position = {0, 0, 0.05};
    world.bodies = {slab, ball("cue", 0.2, 0)};
    world.bodies[1].pose.position.z = 0.1 + kRadius;
    return world;
}

TEST(BallOnASolid_SetInMotion, RollsAndIsNotAirborne) {
    WorldDescription world = ball_on_a_slab();
    SetVelocity roll;
    roll.linear = Vec3(-0.1, 0, 0);
    world.events = {event_on("cue", 0.5, roll),
                    event_on("cue", 1, Force{{0.05, 0, 0}, 0.2, {0, 0, 0}, Axes::world})};
    EXPECT_EQ(kinds_of(bake(world), "cue"),
              (std::vector<EventKind>{EventKind::resting, EventKind::velocity, EventKind::force}));
}

TEST(BallOnASolid_ThrownUp, IsAirborne) {
    WorldDescription world = ball_on_a_slab();
    SetVelocity jump;
    jump.linear = Vec3(0, 0, 1);
    world.events = {event_on("cue", 0.5, jump)};
    const std::vector<EventKind> kinds = kinds_of(bake(world), "cue");
    EXPECT_EQ(std::count(kinds.begin(), kinds.end(), EventKind::airborne), 1);
}

TEST(Torque_AboutTheVertical, SpinsTheBall) {
    WorldDescription world = cloth_world(0.2);
    world.contact_law.ball_cloth.spinning_friction = 0;
    world.bodies = {ball("cue", 0, 0)};
    world.events = {event_on("cue", 0, Torque{{0, 0, 1e-3}, 0.1, Axes::world})};
    const double inertia = 0.4 * kMass * kRadius * kRadius;
    EXPECT_NEAR(state_at(bake(world), "cue", 0.2).angular_velocity.z, 1e-4 / inertia, 1e-9);
}

TEST(SetVelocity_OnlyOnePart, KeepsTheOther) {
    WorldDescription world = cloth_world(0.1);
    world.bodies = {ball("cue", 0, 0, {1, 0, 0})};
    SetVelocity velocity;
    velocity.angular = Vec3(0, 0, 9);
    world.events = {event_on("cue", 0, velocity)};
    const Key key = key_at(bake(world), "cue", 0);
    EXPECT_EQ(key.velocity_out, Vec3(1, 0, 0));
    EXPECT_EQ(key.angular_velocity_out, Vec3(0, 0, 9));
}

TEST(Strike_TowardABall, HitsItAndIsLogged) {
    WorldDescription world = cloth_world(2);
    world.bodies = {ball("cue", -0.5, 0.2), ball("one", 0.3, -0.1)};
    world.events = {strike_towards("cue", "one", 2.5, 0.5)};
    const Timeline result = bake(world);
    EXPECT_TRUE(result.warnings.empty());
    const Event* strike = find_event(result, EventKind::strike, "cue");
    ASSERT_NE(strike, nullptr);
    EXPECT_NEAR(strike->vector.length(), 1.73 * 2.5 / (1 + kMass / 0.567), 1e-12);
    EXPECT_NEAR(strike->normal_impulse, kMass * strike->vector.length(), 1e-15);
    EXPECT_EQ(strike->place, Vec3(-0.5, 0.2, kRadius));
    const Event* impact = find_event(result, EventKind::impact, "cue", "one");
    ASSERT_NE(impact, nullptr);
    const Vec3 line = Vec3(-0.8, 0.3, 0) / Vec3(-0.8, 0.3, 0).length();
    EXPECT_NEAR((impact->normal - line).length(), 0, 1e-9);
}

TEST(Strike_FarOffCentre_IsWarnedOf, AndOnlyThat) {
    for (const Vec2& tip : {Vec2(0, -0.6), Vec2(0.51, 0), Vec2(-0.4, 0.4), Vec2(0.35, 0.35),
                            Vec2(0, 0.49), Vec2(-0.3, -0.3)}) {
        WorldDescription world = cloth_world(0.5);
        world.bodies = {ball("cue", 0, 0), ball("one", 0.5, 0)};
        world.events = {strike_towards("cue", "one", 4, 0, tip)};
        const std::vector<Diagnostic> warnings = bake(world).warnings;
        const bool is_warned = !warnings.empty() && warnings[0].field == "tip" &&
                               warnings[0].subject == Subject::event(0);
        EXPECT_EQ(is_warned, tip.length() > 0.5) << tip.x << " " << tip.y;
    }
}

TEST(Strike_ThatNeverArrives, IsWarnedOf) {
    WorldDescription world = cloth_world(1);
    world.bodies = {ball("cue", 0, 0), ball("one", 2, 0)};
    world.events = {strike_towards("cue", "one", 0.2)};
    const Timeline result = bake(world);
    EXPECT_EQ(
        result.warnings,
        (std::vector<Diagnostic>{{Subject::event(0), "toward",
                                  "strike on 'cue' at 0.000 s: the ball never hit its target 'one'",
                                  Severity::warning}}));
}

TEST(Trigger_Contact, FiresAfterTheFirstImpact) {
    WorldDescription world = cloth_world(2);
    world.bodies = {ball("cue", -0.3, 0, {1.5, 0, 0}), ball("one", 0, 0), ball("two", 0, 1)};
    ForceEvent event = event_on("two", 0, Impulse{{0.1, 0, 0}, {0, 0, 0}, Axes::world});
    event.trigger = Trigger{Trigger::Kind::contact, "one", "cue"};
    event.after = 0.1;
    world.events = {event};
    const Timeline timeline = bake(world);
    const Event* impact = find_event(timeline, EventKind::impact, "cue", "one");
    const Event* impulse = find_event(timeline, EventKind::impulse, "two");
    ASSERT_NE(impact, nullptr);
    ASSERT_NE(impulse, nullptr);
    EXPECT_NEAR(impulse->time, impact->time + 0.1, 1e-12);
}

TEST(Trigger_AllResting, FiresWhenTheLastBallStops) {
    WorldDescription world = cloth_world(20);
    world.bodies = {ball("cue", 0, 0, {0.5, 0, 0}), ball("one", 0, 1, {0.3, 0, 0})};
    ForceEvent event = event_on("one", 0, Impulse{{0.01, 0, 0}, {0, 0, 0}, Axes::world});
    event.trigger = Trigger{Trigger::Kind::resting, "", ""};
    world.events = {event};
    const Timeline timeline = bake(world);
    const Event* resting = find_event(timeline, EventKind::resting, "cue");
    const Event* impulse = find_event(timeline, EventKind::impulse, "one");
    ASSERT_NE(impulse, nullptr);
    EXPECT_EQ(impulse->time, resting->time);
}

TEST(Trigger_ThatNeverHappens, IsWarnedOf) {
    WorldDescription world = cloth_world(0.5);
    world.bodies = {ball("cue", 0, 0), ball("one", 1, 0)};
    ForceEvent event = event_on("cue", 0, Impulse{{0.01, 0, 0}, {0, 0, 0}, Axes::world});
    event.trigger = Trigger{Trigger::Kind::contact, "cue", "one"};
    world.events = {event_on("cue", 0, Torque{{0, 0, 1e-6}, 0.1, Axes::world}), event};
    const Timeline result = bake(world);
    EXPECT_EQ(
        result.warnings,
        (std::vector<Diagnostic>{{Subject::event(1), "when",
                                  "event 2 on 'cue' never happened: 'cue' never touched 'one'",
                                  Severity::warning}}));
}

TEST(Bake_StoppedBeforeItBegins, ThrowsStopped) {
    WorldDescription world = cloth_world(1);
    world.bodies = {ball("cue", 0, 0, {1, 0, 0})};
    std::stop_source source;
    source.request_stop();
    WorkContext context;
    context.stop = source.get_token();
    EXPECT_THROW((void)bake(world, context), Stopped);
}

TEST(BakeWithin_AStepLimit, GivesTheSameBakeOrNone) {
    WorldDescription world = nine_ball_world(2);
    world.events = {strike_towards("cue", "one", 6)};
    std::uint64_t most = 1;
    while (!bake_within(most, world)) {
        most *= 2;
    }
    EXPECT_GT(most, 100U);  // only impacts
    EXPECT_EQ(bake_within(most, world)->events, bake(world).events);
    EXPECT_FALSE(bake_within(most / 2, world));
    EXPECT_FALSE(bake_within(0, world));
}

TEST(Bake_Progress, RisesToOne) {
    WorldDescription world = cloth_world(1);
    world.bodies = {ball("cue", 0, 0, {1, 0, 0})};
    std::vector<double> fractions;
    WorkContext context;
    context.progress = [&](double fraction) { fractions.push_back(fraction); };
    (void)bake(world, context);
    ASSERT_FALSE(fractions.empty());
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.back(), 1);
}

TEST(Strike_OnMovingBalls, ReachesOnlyThoseThatDoNotOutrunIt) {
    WorldDescription world = cloth_world(0.6);
    world.contact_law.ball_cloth = {0, 0, 0, 0.5};
    world.bodies = {ball("away", -2, 0, {3, 0, 0}), ball("toward", 2, 1, {-3, 0, 0}),
                    ball("rest", 0, 2)};
    for (const Body& body : world.bodies) {
        ForceEvent event;
        event.object = body.name;
        event.time = 0.5;
        Strike strike;
        strike.direction = 0;
        strike.speed = 1;
        event.action = strike;
        world.events.push_back(event);
    }
    const Timeline timeline = bake(world);
    const double rest = 1.73 / (1 + kMass / 0.567);
    EXPECT_EQ(state_at(timeline, "away", 0.6).velocity, Vec3(3, 0, 0));
    EXPECT_NEAR(state_at(timeline, "toward", 0.6).velocity.x, 4 * rest - 3, 1e-12);
    EXPECT_NEAR(state_at(timeline, "rest", 0.6).velocity.x, rest, 1e-12);
    EXPECT_EQ(count_events(timeline, EventKind::strike), 2);
    ASSERT_EQ(timeline.warnings.size(), 1U);
    EXPECT_EQ(
        timeline.warnings[0].sentence,
        "strike on 'away' at 0.500 s: the ball moves away from the stick as fast as the stick "
        "comes, or faster; the strike is skipped");
    EXPECT_EQ(timeline.warnings[0].field, "speed");
}

// Thirty of these once put 30 million impulses into the schedule before the shot began.
TEST(Force_OfAnHourInAShortShot, IsThatOfTheTimeThatItActs) {
    WorldDescription world = cloth_world(0.3);
    world.contact_law.ball_cloth = {0, 0, 0, 0.5};
    world.bodies = {ball("cue", 0, 0)};
    for (int i = 0; i < 30; ++i) {
        world.events.push_back({"cue", 0.1, {}, 0, Force{{0.01, 0, 0}, 3600, {}, Axes::world}});
    }
    const Timeline timeline = bake(world);
    // Impulses every 3.6 ms: there are never more than a million.
    EXPECT_NEAR(state_at(timeline, "cue", 0.3).velocity.x, 30 * 0.01 * 0.2 / kMass, 0.008);
}

}  // namespace
}  // namespace carom::sim::test
