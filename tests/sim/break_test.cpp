// A whole nine-ball break.
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
    const Timeline timeline = bake(world).timeline;
    ASSERT_GT(count_events(timeline, EventKind::impact), 50);
    const double before = timeline.energy.front().total();
    for (const EnergySample& sample : timeline.energy)
        EXPECT_NEAR(sample.total() / before, 1, 1e-9) << sample.time;
}

TEST(Break_WithLosses, NeverGainsEnergy) {
    const Timeline timeline = bake(break_shot()).timeline;
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
    Bake first{bake(world).timeline, physics_hash(world), "", {}};
    Bake second{bake(world).timeline, physics_hash(world), "", {}};
    EXPECT_EQ(encode_bake(first), encode_bake(second));
}

TEST(Break_BakedOnTwoThreadsAtOnce, IsTheSame) {
    const WorldDescription world = break_shot();
    const Timeline alone = bake(world).timeline;
    std::vector<Timeline> timelines(2);
    {
        std::jthread a([&] { timelines[0] = bake(world).timeline; });
        std::jthread b([&] { timelines[1] = bake(world).timeline; });
    }
    EXPECT_EQ(timelines[0], alone);
    EXPECT_EQ(timelines[1], alone);
}

TEST(Break_Balls, NeverOverlapNorLeaveTheTableUnseen) {
    const WorldDescription world = break_shot();
    const BakeResult result = bake(world);
    EXPECT_TRUE(result.warnings.empty());
    for (double t = 0; t < 6; t += 1.0 / 120) {
        for (std::size_t i = 0; i < world.bodies.size(); ++i) {
            const Vec3 p = state_at(result.timeline, world.bodies[i].name, t).position;
            for (std::size_t j = 0; j < i; ++j) {
                const Vec3 q = state_at(result.timeline, world.bodies[j].name, t).position;
                ASSERT_GT((p - q).length(), 2 * kRadius - 1e-5)
                    << world.bodies[i].name << " " << world.bodies[j].name << " " << t;
            }
        }
    }
}

}  // namespace
}  // namespace carom::sim::test
