// Many balls: no impact is missed, and balls that take no part change nothing.
#include <cmath>

#include <gtest/gtest.h>

#include "shots.h"

namespace carom::sim::test {
namespace {

/// `rows` x 2 `rows` balls on a table without pockets, moving in different directions.
WorldDescription crowd(int rows, double duration) {
    WorldDescription world = walled_world(duration);
    world.table->kind = billiards::TableKind::custom;
    world.table->width = 0.3 * rows;
    world.table->length = 0.6 * rows;
    for (int i = 0; i < 2 * rows * rows; ++i) {
        const double x = 0.3 * (i / rows + 0.5) - 0.5 * world.table->length;
        const double y = 0.3 * (i % rows + 0.5) - 0.5 * world.table->width;
        const Vec3 velocity(3 * std::sin(1.0 + 7.1 * i), 3 * std::cos(2.0 + 3.7 * i), 0);
        world.bodies.push_back(ball("ball" + std::to_string(i), x, y, velocity));
    }
    return world;
}

TEST(Crowd_OfBalls, NeverOverlapsNorLeavesTheTable) {
    const WorldDescription world = crowd(8, 2);
    const Timeline result = bake(world);
    EXPECT_TRUE(result.warnings.empty());
    ASSERT_GT(count_events(result, EventKind::impact), 128);
    std::vector<Vec3> places(world.bodies.size());
    for (double t = 0; t <= 2; t += 1.0 / 60) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            places[i] = state_at(result, world.bodies[i].name, t).position;
            ASSERT_LT(std::abs(places[i].x), 0.5 * world.table->length - kRadius + 1e-5);
            ASSERT_LT(std::abs(places[i].y), 0.5 * world.table->width - kRadius + 1e-5);
            for (std::size_t j = 0; j < i; ++j) {
                ASSERT_GT((places[i] - places[j]).length(), 2 * kRadius - 1e-5) << i << " " << j;
            }
        }
    }
}

// Without bodies in ODE the step has no effect.
TEST(Crowd_WithAnyStep, IsTheSame) {
    WorldDescription world = crowd(4, 1.5);
    const Timeline coarse = bake(world);
    world.step = 1e-3;
    EXPECT_EQ(bake(world), coarse);
}

// A huge ball far away makes the grid's cells wider. Then pairs are tested at other times, but the
// motion is the same (up to rounding, which impacts amplify).
TEST(Crowd_InWiderCells, MovesTheSame) {
    WorldDescription world = crowd(3, 0.5);
    const Timeline narrow = bake(world);
    world.bodies.push_back(ball("huge", 50, 0));
    world.bodies.back().shape = Sphere{0.3};
    world.bodies.back().pose.position.z = 3;
    world.gravity = {0, 0, -9.81};
    const Timeline wide = bake(world);
    for (const Body& body : world.bodies) {
        if (body.name == "huge") {
            continue;
        }
        const Vec3 a = state_at(narrow, body.name, 0.5).position;
        const Vec3 b = state_at(wide, body.name, 0.5).position;
        EXPECT_NEAR((a - b).length(), 0, 1e-9) << body.name;
    }
}

TEST(Crowd_OfRestingBallsWithOneMoving, IsHitInTurn) {
    WorldDescription world = cloth_world(4);
    world.contact_law.ball_ball = {1, 0, BallFriction::constant};
    world.contact_law.ball_cloth = {0, 0, 0, 0.5};
    for (int i = 0; i < 40; ++i) {
        world.bodies.push_back(ball("ball" + std::to_string(i), 0.1 * i, 0));
    }
    world.bodies[0].velocity = {2, 0, 0};
    const Timeline timeline = bake(world);
    // Newton's cradle with gaps: each ball passes its velocity on after it has closed the next gap.
    ASSERT_EQ(count_events(timeline, EventKind::impact), 39);
    EXPECT_NEAR(state_at(timeline, "ball39", 4).velocity.x, 2, 1e-12);
    double expected = 0;
    for (const Event& event : timeline.events) {
        if (event.kind != EventKind::impact) {
            continue;
        }
        expected += (0.1 - 2 * kRadius) / 2;
        EXPECT_NEAR(event.time, expected, 1e-12);
    }
}

}  // namespace
}  // namespace carom::sim::test
