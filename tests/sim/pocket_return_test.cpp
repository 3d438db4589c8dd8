// The ball return: a pocket keeps the last balls that fell in, and the earlier ones leave.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pocket_shots.h"
#include "shots.h"
#include "sim/timeline/energy.h"

namespace carom::sim::test {
namespace {

/// `count` balls in an arc around the pocket's mouth, which roll towards its middle at `speed`, one
/// `interval` (s) after the other.
WorldDescription fan(const PocketTable& table, const billiards::PocketLayout& pocket, int count,
                     double speed, double interval) {
    constexpr double kDistance = 0.75;  // m
    const double apart = (2 * table.radius + 0.001) / kDistance;
    WorldDescription world;
    world.table = billiards::standard_table(table.kind, table.size);
    for (int i = 0; i < count; ++i) {
        const double angle = (i - 0.5 * (count - 1)) * apart;
        const Vec2 axis =
            pocket.axis * std::cos(angle) + Vec2(-pocket.axis.y, pocket.axis.x) * std::sin(angle);
        const Vec2 place = pocket.mouth - axis * kDistance;
        Body body = ball("b" + std::to_string(i), place.x, place.y);
        body.shape = Sphere{table.radius};
        body.mass = table.mass;
        body.pose.position.z = table.radius;
        world.bodies.push_back(body);
        SetVelocity roll;
        roll.linear = Vec3(axis.x * speed, axis.y * speed, 0);
        roll.angular = rolling_spin(*roll.linear, table.radius);
        ForceEvent event;
        event.object = body.name;
        // From the middle outwards, left and right in turn.
        event.time = interval * std::abs(2 * i - (count - 1) + 0.5);
        event.action = roll;
        world.events.push_back(event);
    }
    world.duration = count * interval + 1.5 * kDistance / speed + 3;
    return world;
}

bool is_below_floor(const Vec3& centre, const billiards::Pocket& pocket) {
    return centre.z < -pocket.drop;
}

/// All balls are potted once and at rest at the end; at most `kept` of them lie in the pocket, the
/// last ones.
void expect_all_potted(const WorldDescription& world, const Timeline& timeline,
                       const billiards::Pocket& pocket, std::size_t kept,
                       const std::string& where) {
    EXPECT_TRUE(timeline.warnings.empty())
        << where << ": " << (timeline.warnings.empty() ? "" : timeline.warnings[0].sentence);
    EXPECT_EQ(count_events(timeline, EventKind::potted), static_cast<int>(world.bodies.size()))
        << where;
    // ODE's contacts in the pocket are up to 4 um deep, which lifts a ball by as much.
    EXPECT_LE(largest_energy_rise(timeline), 5e-5) << where;
    std::size_t inside = 0;
    for (const Body& body : world.bodies) {
        const MotionState end = state_at(timeline, body.name, world.duration);
        EXPECT_EQ(end.velocity, Vec3(0, 0, 0)) << where << ", " << body.name;
        EXPECT_LT(end.position.z, 0) << where << ", " << body.name;
        inside += is_below_floor(end.position, pocket) ? 0 : 1;
    }
    EXPECT_EQ(inside, std::min(kept, world.bodies.size())) << where;
}

/// Number of balls over the hole that are not potted and touch a ball that is.
int balls_on_others(const WorldDescription& world, const Timeline& timeline,
                    const billiards::Pocket& pocket) {
    int count = 0;
    for (const Body& upper : world.bodies) {
        const Vec3 centre = state_at(timeline, upper.name, world.duration).position;
        if (find_event(timeline, EventKind::potted, upper.name) != nullptr ||
            (Vec2(centre.x, centre.y) - pocket.centre).length() > pocket.radius) {
            continue;
        }
        for (const Body& lower : world.bodies) {
            const Vec3 d = state_at(timeline, lower.name, world.duration).position - centre;
            const double touching = 2 * std::get<Sphere>(upper.shape).radius + 1e-3;
            const bool is_potted = find_event(timeline, EventKind::potted, lower.name) != nullptr;
            count += is_potted && d.z < -0.01 && d.length() < touching ? 1 : 0;
        }
    }
    return count;
}

const billiards::PocketLayout& pocket_of(const billiards::TableLayout& layout, bool is_corner) {
    return *std::find_if(layout.pockets.begin(), layout.pockets.end(),
                         [&](const auto& pocket) { return pocket.is_corner == is_corner; });
}

TEST(BallReturn_FrameRolledIntoOnePocketOneByOne, AllArePottedAndTheLastTwoStay) {
    for (const PocketTable& table : pocket_tables()) {
        const billiards::TableLayout layout = table.layout();
        for (const bool is_corner : {true, false}) {
            const billiards::PocketLayout& pocket = pocket_of(layout, is_corner);
            for (const double interval : {0.4, 0.8}) {
                const WorldDescription world = fan(table, pocket, 15, 1.2, interval);
                expect_all_potted(world, bake(world), pocket.pocket, 2,
                                  std::string(table.size) + " " + pocket.pocket.name + " " +
                                      std::to_string(interval));
            }
        }
    }
}

// Balls that arrive together push each other away, and some may hold each other over the edge of
// the hole. But no ball rests on those that fell in before it.
TEST(BallReturn_FrameRolledIntoOnePocketAtOnce, NoneRestsOnTheBallsInIt) {
    for (const PocketTable& table : pocket_tables()) {
        const billiards::TableLayout layout = table.layout();
        for (const bool is_corner : {true, false}) {
            const billiards::PocketLayout& pocket = pocket_of(layout, is_corner);
            for (const double speed : {0.6, 1.2, 2.5, 5.0}) {
                for (const double interval : {0.0, 0.01, 0.03, 0.06}) {
                    const WorldDescription world = fan(table, pocket, 15, speed, interval);
                    const Timeline timeline = bake(world);
                    EXPECT_EQ(balls_on_others(world, timeline, pocket.pocket), 0)
                        << table.size << " " << pocket.pocket.name << " " << speed << " "
                        << interval;
                }
            }
        }
    }
}

// What falls through the floor falls freely: from rest to 20 mm below the floor.
TEST(BallReturn_FirstBallOfThree, FallsFreelyThroughTheFloorAndRests) {
    const PocketTable& table = pocket_tables()[0];
    const billiards::TableLayout layout = table.layout();
    const billiards::PocketLayout& pocket = pocket_of(layout, true);
    const WorldDescription world = fan(table, pocket, 3, 1.2, 1.5);
    const Timeline timeline = bake(world);
    expect_all_potted(world, timeline, pocket.pocket, 2, "");
    const Event& third = *find_event(timeline, EventKind::potted, "b2");
    double rested = 0;
    for (const Event& event : timeline.events) {
        rested = event.kind == EventKind::resting && event.a == "b1" ? event.time : rested;
    }
    const double fall = 2 * table.radius + 0.02;
    EXPECT_NEAR(rested, third.time + std::sqrt(2 * fall / kGravity), 2e-3);
    const double rest_height = table.radius - pocket.pocket.drop;
    const Track& track = *timeline.find("b1");
    EXPECT_NEAR(track.sample(third.time).position.z, rest_height, 1e-4);
    EXPECT_NEAR(track.sample(world.duration).position.z, rest_height - fall, 1e-4);
    const double half_time = 0.5 * (rested - third.time);
    EXPECT_NEAR(track.sample(third.time + half_time).position.z, rest_height - fall / 4, 1e-3);
}

/// A fourth stroke waits until the first ball has come to rest below the floor.
TEST(BallReturn_RestTrigger, WaitsForTheBallThatLeaves) {
    const PocketTable& table = pocket_tables()[0];
    const billiards::TableLayout layout = table.layout();
    WorldDescription world = fan(table, pocket_of(layout, true), 3, 1.2, 1.5);
    world.bodies.push_back(ball("last", 0.5, 0.3));
    SetVelocity roll;
    roll.linear = Vec3(0.1, 0, 0);
    ForceEvent event;
    event.object = "last";
    event.action = roll;
    event.time = 4.6;  // when the third ball is rolling
    event.trigger = Trigger{Trigger::Kind::resting, "", ""};
    world.events.push_back(event);
    const Timeline timeline = bake(world);
    double last_rest = 0;
    for (const Event& e : timeline.events) {
        last_rest = e.kind == EventKind::resting && e.a != "last" ? e.time : last_rest;
    }
    const Event* stroke = find_event(timeline, EventKind::velocity, "last");
    ASSERT_NE(stroke, nullptr);
    EXPECT_GE(stroke->time, last_rest);
    EXPECT_LT(stroke->time, last_rest + 0.02);
}

/// A ball that has left does not come back.
TEST(BallReturn_ForceOnABallThatHasLeft, HasNoEffectAndIsWarnedOf) {
    const PocketTable& table = pocket_tables()[0];
    const billiards::TableLayout layout = table.layout();
    const billiards::PocketLayout& pocket = pocket_of(layout, true);
    WorldDescription world = fan(table, pocket, 3, 1.2, 1.5);
    world.events.push_back(world.events[1]);
    world.events.back().time = world.duration - 0.5;
    const Timeline timeline = bake(world);
    EXPECT_EQ(timeline.warnings,
              (std::vector<Diagnostic>{{Subject::body("b1"), "",
                                        "'b1' has left the table through its ball return: nothing "
                                        "moves it any more",
                                        Severity::warning}}));
    EXPECT_LT(state_at(timeline, "b1", world.duration).position.z, -pocket.pocket.drop);
}

TEST(BallReturn_ColumnOfBallsDroppedIn, AllArePottedAndTheLastTwoStay) {
    for (const PocketTable& table : pocket_tables()) {
        const billiards::TableLayout layout = table.layout();
        for (const bool is_corner : {true, false}) {
            const billiards::PocketLayout& pocket = pocket_of(layout, is_corner);
            WorldDescription world;
            world.duration = 7;
            world.table = billiards::standard_table(table.kind, table.size);
            for (int i = 0; i < 21; ++i) {
                Body body =
                    ball("b" + std::to_string(i), pocket.pocket.centre.x, pocket.pocket.centre.y);
                body.shape = Sphere{table.radius};
                body.pose.position.z = 0.05 + (2 * table.radius + 0.0004) * i;
                world.bodies.push_back(body);
            }
            const Timeline timeline = bake(world);
            const std::string where = std::string(table.size) + " " + pocket.pocket.name;
            expect_all_potted(world, timeline, pocket.pocket, 2, where);
        }
    }
}

}  // namespace
}  // namespace carom::sim::test
