// A complete nine-ball break.
#include <atomic>
#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "shots.h"
#include "sim/timeline/bake_file.h"

namespace carom::sim::test {
namespace {

WorldDescription break_shot() {
    WorldDescription world = nine_ball_world(6);
    world.events = {strike_towards("cue", "one", 9.2, 0.5, {0, 0.3}, 0.0523599)};
    return world;
}

TEST(Break_Elastic, KeepsItsEnergy) {
    WorldDescription world = walled_world(3);
    world.bodies = nine_ball_world(3).bodies;
    world.contact_law.ball_ball = {1, 0, BallFriction::constant};
    world.contact_law.ball_cushion = {CushionModel::mirror, 1, 0};
    world.contact_law.ball_cloth = {0, 0, 0, 1};
    world.bodies[0].velocity = {9, -1.07, 0};
    const Timeline timeline = bake(world);
    ASSERT_GT(count_events(timeline, EventKind::impact), 50);
    const double before = timeline.energy.front().total();
    for (const EnergySample& sample : timeline.energy) {
        EXPECT_NEAR(sample.total() / before, 1, 1e-9) << sample.time;
    }
}

TEST(Break_WithLosses, NeverGainsEnergy) {
    const Timeline timeline = bake(break_shot());
    double last = 1e300;
    for (const EnergySample& sample : timeline.energy) {
        if (sample.time > 0.5) {
            EXPECT_LE(sample.total(), last + 1e-9) << sample.time;
            last = sample.total();
        }
    }
    ASSERT_LT(last, 1e300);
}

TEST(Break_BakedTwice, IsTheSameBytes) {
    const WorldDescription world = break_shot();
    Bake first{bake(world), physics_hash(world), "", {}};
    Bake second{bake(world), physics_hash(world), "", {}};
    EXPECT_EQ(encode_bake(first), encode_bake(second));
}

/// A short break that runs into a row of boxes: impacts, stepping, box against triangles.
WorldDescription crowded_shot() {
    WorldDescription world = nine_ball_world(1.2);
    world.events = {strike_towards("cue", "one", 9.2, 0.0, {0, 0.3}, 0.0523599)};
    for (int i = 0; i < 4; ++i) {
        Body box;
        box.name = "box" + std::to_string(i);
        box.shape = Box{{0.02, 0.06, 0.06}};
        box.mass = 0.05;
        box.material = "wood";
        box.pose.position = {-0.2, -0.3 + 0.2 * i, 0.03};
        world.bodies.push_back(box);
    }
    return world;
}

// By default ODE's worlds share a threading implementation. Then the results would differ from run
// to run, or this test would crash.
TEST(Break_BakedConcurrently, IsAlwaysTheSame) {
    const WorldDescription world = crowded_shot();
    const Timeline alone = bake(world);
    std::atomic<int> different = 0;
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < 3; ++i) {
            threads.emplace_back([&] {
                for (int k = 0; k < 5; ++k) {
                    different += bake(world) == alone ? 0 : 1;
                }
            });
        }
    }
    EXPECT_EQ(different, 0);
}

TEST(Break_Balls, NeverOverlap) {
    const WorldDescription world = break_shot();
    const Timeline result = bake(world);
    EXPECT_TRUE(result.warnings.empty());
    for (double t = 0; t < 6; t += 1.0 / 120) {
        for (std::size_t i = 0; i < world.bodies.size(); ++i) {
            const Vec3 p = state_at(result, world.bodies[i].name, t).position;
            for (std::size_t j = 0; j < i; ++j) {
                const Vec3 q = state_at(result, world.bodies[j].name, t).position;
                ASSERT_GT((p - q).length(), 2 * kRadius - 1e-5)
                    << world.bodies[i].name << " " << world.bodies[j].name << " " << t;
            }
        }
    }
}

}  // namespace
}  // namespace carom::sim::test
