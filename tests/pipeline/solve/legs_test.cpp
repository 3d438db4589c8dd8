// The legs of a ball's way, by its events.
#include "pipeline/solve/legs.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/billiards/table.h"
#include "sim/trials.h"

namespace carom::pipeline::solve {
namespace {

constexpr double kRadius = 0.028575;

sim::WorldDescription table_with(std::vector<std::pair<std::string, Vec2>> balls) {
    sim::WorldDescription world;
    world.duration = 20;
    world.table = *sim::billiards::standard_table(sim::billiards::TableKind::pool, "9 ft");
    for (const auto& [name, place] : balls) {
        sim::Body body;
        body.name = name;
        body.shape = sim::Sphere{kRadius};
        body.pose.position = Vec3(place.x, place.y, kRadius);
        world.bodies.push_back(body);
    }
    return world;
}

std::vector<Leg> legs_after(const sim::WorldDescription& world, const std::string& ball,
                            double direction, double speed) {
    const sim::Trials trials(world);
    sim::Strike strike;
    strike.speed = speed;
    strike.direction = direction;
    const auto outcome = trials.run({{"cue", 0, {}, 0, strike}});
    return legs_of(ball, outcome->events, radii_of(world));
}

TEST(LegTest, MissIsTheSignedDistance_AheadOnly) {
    const Leg leg{1, {1, 1}, {0, 1}, 2};
    EXPECT_DOUBLE_EQ(leg.miss({1.3, 2}), -0.3);
    EXPECT_DOUBLE_EQ(leg.miss({0.8, 5}), 0.2);
    EXPECT_TRUE(std::isnan(leg.miss({1, 0})));
}

TEST(LegTest, WayOffACushion_BeginsAnotherLeg) {
    const std::vector<Leg> legs = legs_after(table_with({{"cue", {0, 0}}}), "cue", 0.5, 0.9);
    ASSERT_GE(legs.size(), 2U);
    EXPECT_NEAR(legs[0].direction.x, std::cos(0.5), 1e-3);
    EXPECT_NEAR(legs[0].direction.y, std::sin(0.5), 1e-3);
    EXPECT_NEAR(legs[1].from.y, 0.635 - kRadius, 2e-3);
    EXPECT_LT(legs[1].direction.y, 0);
    EXPECT_NE(legs[0].cause, legs[1].cause);
}

TEST(LegTest, CauseTellsTheWayOfTheBall_NotItsPlaces) {
    const sim::WorldDescription world = table_with({{"cue", {-0.5, 0}}, {"one", {0.3, 0}}});
    const auto near = legs_after(world, "one", 0.005, 1.2);
    const auto other = legs_after(world, "one", 0.01, 1.2);
    ASSERT_FALSE(near.empty());
    ASSERT_FALSE(other.empty());
    EXPECT_EQ(near.front().cause, other.front().cause);
    EXPECT_NE(near.front().direction, other.front().direction);
    EXPECT_EQ(leg_with(other, near.front().cause), &other.front());
    EXPECT_EQ(leg_with(other, 12345), nullptr);
    // Off the back cushion first.
    int kicks = 0;
    for (double angle = 0.9; angle < 1.2; angle += 0.01) {
        for (const Leg& kicked : legs_after(world, "one", angle, 2.5)) {
            EXPECT_NE(kicked.cause, near.front().cause);
            ++kicks;
        }
    }
    EXPECT_GT(kicks, 0);
}

TEST(LegTest, SidesOfTheTable) {
    EXPECT_EQ(side_of({0, -1, 0}), "back");
    EXPECT_EQ(side_of({0, 1, 0.2}), "front");
    EXPECT_EQ(side_of({-1, 0, 0}), "right");
    EXPECT_EQ(side_of({1, 0, 0}), "left");
    EXPECT_EQ(side_of({0.7, 0.7, 0}), "");
}

}  // namespace
}  // namespace carom::pipeline::solve
