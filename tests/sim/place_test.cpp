// Events that put balls down on the table and take them off.
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "shots.h"
#include "sim/timeline/bake_file.h"
#include "sim/timeline/energy.h"

namespace carom::sim::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

ForceEvent place(const std::string& ball, const Vec2& at, double time,
                 PlaceBall::IfOccupied if_occupied = PlaceBall::IfOccupied::wait,
                 const std::string& spot = {}) {
    ForceEvent event;
    event.object = ball;
    event.time = time;
    event.action = PlaceBall{at, spot, if_occupied};
    return event;
}

ForceEvent remove(const std::string& ball, double time) {
    ForceEvent event;
    event.object = ball;
    event.time = time;
    event.action = RemoveBall{};
    return event;
}

ForceEvent when_rested(ForceEvent event, const std::string& name = {}) {
    event.trigger = Trigger{Trigger::Kind::resting, name, ""};
    return event;
}

WorldDescription pool_world(double duration) {
    WorldDescription world;
    world.contact_law = constant_law();
    world.duration = duration;
    world.table = billiards::standard_table(billiards::TableKind::pool, "9 ft");
    world.floor_height = -world.table->height;
    return world;
}

std::vector<std::string> warnings_of(const Timeline& timeline) {
    return sentences_of(timeline.warnings);
}

std::vector<double> times_of(const Timeline& timeline, EventKind kind, const std::string& ball) {
    std::vector<double> times;
    for (const Event& event : timeline.events) {
        if (event.kind == kind && event.a == ball) {
            times.push_back(event.time);
        }
    }
    return times;
}

TEST(PlacedBall, ThatMoves_LiesAtRestFromThatInstant) {
    WorldDescription world = pool_world(2);
    world.bodies = {ball("cue", -0.9, 0.2, {2, 0, 0}, rolling_spin({2, 0, 0}))};
    world.events = {place("cue", {0.3, -0.1}, 0.5)};
    const Timeline timeline = bake(world);
    EXPECT_LT(state_at(timeline, "cue", std::nextafter(0.5, 0.0)).position.x, 0.1);
    for (const double time : {0.5, 0.6, 2.0}) {
        const MotionState state = state_at(timeline, "cue", time);
        EXPECT_EQ(state.position, Vec3(0.3, -0.1, kRadius));
        EXPECT_EQ(state.velocity, Vec3(0, 0, 0));
        EXPECT_EQ(state.angular_velocity, Vec3(0, 0, 0));
    }
    ASSERT_EQ(timeline.put_backs.size(), 1U);
    EXPECT_EQ(timeline.put_backs[0].ball, "cue");
    EXPECT_EQ(timeline.put_backs[0].time, 0.5);
    EXPECT_EQ(timeline.put_backs[0].to, Vec3(0.3, -0.1, kRadius));
    EXPECT_NEAR(timeline.put_backs[0].from.y, 0.2, 1e-12);
    const Event* placed = find_event(timeline, EventKind::placed, "cue");
    ASSERT_NE(placed, nullptr);
    EXPECT_EQ(placed->place, Vec3(0.3, -0.1, kRadius));
    EXPECT_THAT(warnings_of(timeline), IsEmpty());
}

/// Rolls into the pocket at the right front corner within a second.
WorldDescription potting_world(double duration) {
    WorldDescription world = pool_world(duration);
    const Vec3 velocity(1.4, -1.4, 0);
    world.bodies = {ball("one", 0.8, -0.19, velocity, rolling_spin(velocity)),
                    ball("cue", -0.9, 0.3)};
    return world;
}

TEST(PlacedBall, ThatWasPotted_IsStruckAndPottedAgain) {
    WorldDescription world = potting_world(14);
    ForceEvent back = place("one", {0.635, 0}, 0, PlaceBall::IfOccupied::wait, "foot");
    back.trigger = Trigger{Trigger::Kind::potted, "one", ""};
    back.after = 1;
    ForceEvent strike = when_rested(strike_towards("cue", "one", 2));
    strike.time = 3;
    ForceEvent push;
    push.object = "one";
    push.time = 10;
    push.action = SetVelocity{Vec3(1.5, -1.5, 0), Vec3(0, 0, 0)};
    world.events = {back, strike, place("one", {0.8, -0.19}, 9.5), push};
    const Timeline timeline = bake(world);
    const std::vector<double> potted = times_of(timeline, EventKind::potted, "one");
    ASSERT_EQ(potted.size(), 2U);
    EXPECT_LT(potted[0], 1);
    EXPECT_GT(potted[1], 10);
    const std::vector<double> placed = times_of(timeline, EventKind::placed, "one");
    ASSERT_EQ(placed.size(), 2U);
    EXPECT_NEAR(placed[0], potted[0] + 1, 1e-9);
    EXPECT_EQ(find_event(timeline, EventKind::placed, "one")->b, "foot");
    EXPECT_EQ(state_at(timeline, "one", placed[0]).position, Vec3(0.635, 0, kRadius));
    EXPECT_NE(find_event(timeline, EventKind::impact, "one", "cue"), nullptr);
    EXPECT_LT(timeline.put_backs[0].from.z, 0);
    EXPECT_THAT(warnings_of(timeline), IsEmpty());
}

TEST(PlacedBall, ThatLeftThroughTheBallReturn_IsBackInTheGame) {
    WorldDescription world = pool_world(14);
    // Three balls for a pocket that keeps two.
    const Vec3 velocity(1.4, -1.4, 0);
    for (int i = 0; i < 3; ++i) {
        world.bodies.push_back(ball("b" + std::to_string(i), -0.4 + 0.4 * i, 0.3));
        ForceEvent shoot;
        shoot.object = world.bodies.back().name;
        shoot.time = 2.0 * i + 0.5;
        shoot.action = SetVelocity{velocity, rolling_spin(velocity)};
        world.events.push_back(place(shoot.object, {0.8, -0.19}, 2.0 * i));
        world.events.push_back(shoot);
    }
    world.events.push_back(place("b0", {0, 0.2}, 8));
    ForceEvent push;
    push.object = "b0";
    push.time = 9;
    push.action = SetVelocity{Vec3(0.5, 0, 0), Vec3(0, 0, 0)};
    world.events.push_back(push);
    const Timeline timeline = bake(world);
    ASSERT_EQ(count_events(timeline, EventKind::potted), 3);
    EXPECT_LT(state_at(timeline, "b0", 7.9).position.z, -0.1);
    EXPECT_EQ(state_at(timeline, "b0", 8).position, Vec3(0, 0.2, kRadius));
    EXPECT_GT(state_at(timeline, "b0", 14).position.x, 0.1);
    EXPECT_THAT(warnings_of(timeline), IsEmpty());
}

TEST(PlacedBall, InTheWayOfARollingOne_IsHit) {
    WorldDescription world = pool_world(2);
    world.bodies = {ball("cue", -0.9, 0, {2, 0, 0}, rolling_spin({2, 0, 0})),
                    ball("one", 0.5, 0.4)};
    world.events = {place("one", {0, 0}, 0.2)};
    const Timeline timeline = bake(world);
    const Event* hit = find_event(timeline, EventKind::impact, "cue", "one");
    ASSERT_NE(hit, nullptr);
    EXPECT_NEAR(hit->place.x, -kRadius, 1e-6);
}

TEST(PlacedBall, OnAnOccupiedPlace_WaitsUntilItIsFree) {
    WorldDescription world = pool_world(3);
    world.bodies = {ball("two", 0, 0), ball("one", 0.5, 0.4)};
    ForceEvent push;
    push.object = "two";
    push.time = 1;
    push.action = SetVelocity{Vec3(0, 1, 0), rolling_spin({0, 1, 0})};
    world.events = {place("one", {0, 0}, 0.25), push};
    const Timeline timeline = bake(world);
    const std::vector<double> placed = times_of(timeline, EventKind::placed, "one");
    ASSERT_EQ(placed.size(), 1U);
    // As soon as the other ball has rolled away by a diameter, to within a sixtieth of a second.
    EXPECT_GT(placed[0], 1 + 2 * kRadius);
    EXPECT_LT(placed[0], 1 + 2 * kRadius + 1.2 / 60);
    EXPECT_THAT(warnings_of(timeline), IsEmpty());
}

TEST(PlacedBall, WithTheNextPlace_LiesBesideTheOccupant) {
    WorldDescription world = pool_world(1);
    world.bodies = {ball("two", 0.635, 0), ball("one", 0.5, 0.4)};
    world.events = {place("one", {0.635, 0}, 0.25, PlaceBall::IfOccupied::next, "foot")};
    const Timeline timeline = bake(world);
    const Vec3 at = state_at(timeline, "one", 1).position;
    EXPECT_NEAR(at.x, 0.635 + 2 * kRadius + 1e-4, 1e-7);
    EXPECT_EQ(at.y, 0);
    EXPECT_EQ(find_event(timeline, EventKind::placed, "one")->b, "");
}

TEST(PlacedBall, WhosePlaceIsNeverFree_GivesAWarning) {
    WorldDescription world = pool_world(1);
    world.bodies = {ball("two", 0.635, 0), ball("one", 0.5, 0.4)};
    world.events = {place("one", {0.635, 0}, 0.25, PlaceBall::IfOccupied::wait, "foot"),
                    place("one", {0.64, 0}, 0.5)};
    const Timeline timeline = bake(world);
    EXPECT_EQ(count_events(timeline, EventKind::placed), 0);
    EXPECT_THAT(warnings_of(timeline),
                ElementsAre("event 1 on 'one' never happened: event 2 came before its place was "
                            "free",
                            "event 2 on 'one' never happened: its place was never free, at the end "
                            "by 'two'"));
}

TEST(PlacedBall, BesideABody_WaitsForIt) {
    WorldDescription world = pool_world(1);
    Body box;
    box.name = "box";
    box.shape = Box{{0.1, 0.1, 0.1}};
    box.material = "object";
    box.pose.position = {0, 0, 0.05};
    world.bodies = {ball("one", 0.5, 0.4), box};
    world.events = {place("one", {0.05, 0}, 0.25)};
    EXPECT_THAT(warnings_of(bake(world)),
                ElementsAre("event 1 on 'one' never happened: its place was never free, at the end "
                            "by 'box'"));
}

TEST(PlacedBall, AtTheInstantOfAStrike_IsStruckFromThere) {
    WorldDescription world = pool_world(2);
    world.bodies = {ball("cue", -0.9, 0), ball("one", 0.5, 0.4)};
    world.events = {place("cue", {0, 0.4}, 1), strike_towards("cue", "one", 1, 1)};
    const Timeline timeline = bake(world);
    EXPECT_EQ(state_at(timeline, "cue", 1).position, Vec3(0, 0.4, kRadius));
    EXPECT_GT(state_at(timeline, "cue", 1).velocity.x, 1);
    EXPECT_NE(find_event(timeline, EventKind::impact, "cue", "one"), nullptr);
    EXPECT_NEAR(state_at(timeline, "cue", 0.999).position.x, -0.9, 1e-9);
}

TEST(PlacedBall, LeavesTheBallsThatLayOnIt_Falling) {
    WorldDescription world = pool_world(3);
    // A ball on two others, which a frame of fixed boxes holds together.
    world.bodies = {ball("a", -kRadius * 1.0001, 0), ball("b", kRadius * 1.0001, 0),
                    ball("top", 0, 0.4)};
    world.bodies[2].pose.position = {0, 0, kRadius * (1 + std::sqrt(3.0))};
    for (const double side : {-1.0, 1.0}) {
        Body wall;
        wall.name = side < 0 ? "left" : "right";
        wall.kind = BodyKind::fixed;
        wall.shape = Box{{0.02, 0.3, 0.2}};
        wall.material = "object";
        wall.pose.position = {side * (2.0002 * kRadius + 0.01), 0, 0.1};
        world.bodies.push_back(wall);
    }
    world.events = {place("a", {-0.5, 0.3}, 1)};
    const Timeline timeline = bake(world);
    EXPECT_GT(state_at(timeline, "top", 0.99).position.z, 1.5 * kRadius);
    EXPECT_LT(state_at(timeline, "top", 2.5).position.z, 1.1 * kRadius);
}

TEST(PlacedBall, BetweenTwoStrikesThatWaitForRest_IsPutDownAtTheSameRest) {
    WorldDescription world = pool_world(12);
    world.bodies = {ball("cue", -0.9, 0.2), ball("one", 0.5, 0.2)};
    world.events = {strike_towards("cue", "one", 1.5), when_rested(place("one", {0.3, -0.2}, 0)),
                    when_rested(place("cue", {-0.5, -0.2}, 0)),
                    when_rested(strike_towards("cue", "one", 1.5))};
    const Timeline timeline = bake(world);
    EXPECT_THAT(warnings_of(timeline), IsEmpty());
    const std::vector<double> strikes = times_of(timeline, EventKind::strike, "cue");
    ASSERT_EQ(strikes.size(), 2U);
    EXPECT_EQ(times_of(timeline, EventKind::placed, "one"), std::vector<double>{strikes[1]});
    EXPECT_EQ(times_of(timeline, EventKind::placed, "cue"), std::vector<double>{strikes[1]});
}

TEST(PlacedBall, BeforeTheFirstStrike_IsNoMotionForEventsThatWaitForRest) {
    WorldDescription world = pool_world(12);
    world.bodies = {ball("cue", -0.9, 0.2), ball("one", 0.5, 0.2)};
    world.events = {place("one", {0.3, -0.2}, 0.2), strike_towards("cue", "one", 1.5, 1),
                    when_rested(strike_towards("cue", "one", 1.5))};
    const std::vector<double> strikes = times_of(bake(world), EventKind::strike, "cue");
    ASSERT_EQ(strikes.size(), 2U);
    EXPECT_EQ(strikes[0], 1);
    EXPECT_GT(strikes[1], 2);
}

TEST(PlacedBall, WhosePlaceIsOccupiedAtTheRest_HoldsUpTheNextStrike) {
    WorldDescription world = pool_world(18);
    world.bodies = {ball("cue", -0.9, 0.2), ball("one", 0.5, 0.2), ball("two", 0, -0.3)};
    ForceEvent push;
    push.object = "two";
    push.time = 9;
    push.action = SetVelocity{Vec3(0.3, 0, 0), rolling_spin({0.3, 0, 0})};
    world.events = {strike_towards("cue", "one", 0.5), when_rested(place("one", {0, -0.3}, 0)),
                    when_rested(strike_towards("cue", "one", 0.5)), push};
    const Timeline timeline = bake(world);
    const std::vector<double> strikes = times_of(timeline, EventKind::strike, "cue");
    ASSERT_EQ(strikes.size(), 2U);
    EXPECT_GT(times_of(timeline, EventKind::placed, "one").at(0), 9);
    EXPECT_GT(strikes[1], 9.1);  // after the other ball has rolled away and rests
}

TEST(RemovedBall, IsOutOfSightAndTouchesNothing) {
    WorldDescription world = pool_world(4);
    world.bodies = {ball("cue", -0.9, 0, {2, 0, 0}, rolling_spin({2, 0, 0})), ball("one", 0, 0),
                    ball("two", 0.5, 0.3)};
    ForceEvent push;
    push.object = "two";
    push.time = 1;
    push.action = SetVelocity{Vec3(1, 0, 0), Vec3(0, 0, 0)};
    world.events = {remove("one", 0.1), remove("two", 0.2), push, place("two", {0, -0.4}, 3)};
    const Timeline timeline = bake(world);
    EXPECT_EQ(find_event(timeline, EventKind::impact, "cue", "one"), nullptr);
    const Vec3 hidden = state_at(timeline, "one", 2).position;
    EXPECT_LT(hidden.z + kRadius, -0.025);
    EXPECT_GT((state_at(timeline, "two", 2).position - hidden).length(), 2 * kRadius);
    EXPECT_EQ(state_at(timeline, "two", 3.5).position, Vec3(0, -0.4, kRadius));
    EXPECT_EQ(count_events(timeline, EventKind::removed), 2);
    EXPECT_EQ(timeline.put_backs.size(), 1U);
    EXPECT_THAT(warnings_of(timeline),
                ElementsAre("'two' has been taken off the table: nothing moves it"));
}

TEST(PlacedBalls, BakeIsReadBackUnchanged) {
    WorldDescription world = potting_world(4);
    world.events = {place("one", {0.635, 0}, 2), remove("cue", 3)};
    Bake written;
    written.timeline = bake(world);
    EXPECT_EQ(decode_bake(encode_bake(written), "shot.bake").timeline, written.timeline);
}

TEST(PlacedBalls, LeaveTheEnergyBudgetIntact) {
    WorldDescription world = potting_world(5);
    world.events = {place("one", {0.635, 0}, 2)};
    EXPECT_LT(largest_energy_rise(bake(world)), 1e-9);
}

TEST(Place, ImpossiblePlaces_AreRefused) {
    WorldDescription world = pool_world(1);
    Body box;
    box.name = "box";
    box.kind = BodyKind::fixed;
    box.shape = Box{{0.1, 0.1, 0.1}};
    box.pose.position = {0, 0, 0.05};
    world.bodies = {ball("one", 0.5, 0.4), box};
    const auto refusal = [&](const Vec2& at) -> std::string {
        world.events = {place("one", at, 0.5)};
        try {
            (void)bake(world);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(refusal({0.3, 0.1}), "");
    EXPECT_EQ(refusal({2, 0}), "event 1 on 'one': its place is not on the table");
    EXPECT_EQ(refusal({1.260003, 0}), "event 1 on 'one': its place overlaps a cushion by 18.58 mm");
    EXPECT_EQ(refusal({1.2699, -0.6349}), "event 1 on 'one': its place is over a pocket");
    EXPECT_EQ(refusal({0.059997, 0}), "event 1 on 'one': its place overlaps 'box' by 18.58 mm");
}

TEST(Place, Problems_NameTheEvent) {
    WorldDescription world = pool_world(1);
    Body box;
    box.name = "box";
    box.shape = Box{{0.1, 0.1, 0.1}};
    box.pose.position = {0, 0, 0.05};
    world.bodies = {box, ball("one", 0.5, 0.4)};
    world.events = {place("box", {0, 0}, 1), place("one", {NAN, 0}, 1), remove("box", 1)};
    world.respot = billiards::Game::carom;
    EXPECT_THAT(problem_sentences(world),
                ElementsAre("event 1 on 'box': only a ball can be put down",
                            "event 2 on 'one': its place has to be finite",
                            "event 3 on 'box': only a ball can be taken off"));
    world.table.reset();
    world.events = {place("one", {0, 0}, 1), remove("one", 1)};
    EXPECT_THAT(problem_sentences(world),
                ElementsAre("respot needs a table with cushions",
                            "event 1 on 'one': without a table a ball has no place",
                            "event 2 on 'one': without a table a ball cannot be taken off"));
}

}  // namespace
}  // namespace carom::sim::test
