// The total mechanical energy during complete shots.
#include "sim/timeline/energy.h"

#include <gtest/gtest.h>

#include "tests/sim/shots.h"

namespace carom::sim::test {
namespace {

Timeline with_energy(const std::vector<EnergySample>& samples) {
    Timeline timeline;
    timeline.energy = samples;
    return timeline;
}

TEST(LargestEnergyRise, IsMeasuredFromTheLowestEnergyBefore) {
    EXPECT_EQ(largest_energy_rise(with_energy({{0, 4, 1}, {1, 3, 1}, {2, 2, 1}})), 0);
    EXPECT_DOUBLE_EQ(
        largest_energy_rise(with_energy({{0, 4, 0}, {1, 2, 0}, {2, 2.5, 0}, {3, 3, 0}})), 0.25);
}

TEST(LargestEnergyRise, ForceEventsDoNotCount) {
    Timeline timeline = with_energy({{0, 0, 0}, {1, 0, 0}, {1, 5, 0}, {2, 4, 0}, {3, 4.5, 0}});
    EXPECT_GT(largest_energy_rise(timeline), 0.9);
    timeline.events.emplace_back();
    Event& event = timeline.events.back();
    event.kind = EventKind::strike;
    event.time = event.end_time = 1;
    EXPECT_DOUBLE_EQ(largest_energy_rise(timeline), 0.1);
    event.kind = EventKind::force;
    event.end_time = 2.5;
    EXPECT_EQ(largest_energy_rise(timeline), 0);
}

TEST(LargestEnergyRise, IsThatWithoutTheWorkOfKeyedBodies) {
    EXPECT_EQ(largest_energy_rise(with_energy({{0, 1, 0, 0}, {1, 4, 0, 3}, {2, 4, 1, 5}})), 0);
    EXPECT_DOUBLE_EQ(largest_energy_gain(with_energy({{0, 1, 0, 0}, {1, 4, 0, 2.5}})), 0.5);
    EXPECT_DOUBLE_EQ(largest_energy_gain(with_energy({{0, 4, 0, 0}, {1, 3, 0, -2}})), 1);
    // What creeps moves with little energy, and puts in much.
    EXPECT_NEAR(
        largest_energy_rise(with_energy({{0, 1e-6, 0, 0}, {1, 1e-6, -2, -2}, {2, 1e-6, -4, -4.1}})),
        0.1 / 4.1, 1e-12);
}

TEST(Energy_WithLosses, NeverRises) {
    for (const CushionModel model :
         {CushionModel::mirror, CushionModel::han2005, CushionModel::mathavan2010}) {
        for (const bool hop : {false, true}) {
            for (const double speed : {2.0, 9.5}) {
                WorldDescription world = nine_ball_world(5);
                world.floor_height = -world.table->height;
                world.contact_law.ball_cushion = usual_cushion(model);
                world.contact_law.ball_ball.friction_model = BallFriction::alciatore;
                world.contact_law.hop = hop;
                world.events = {strike_towards("cue", "one", speed, 0.2, {0.25, 0.3}, 0.06),
                                strike_towards("cue", "nine", speed, 3, {-0.2, -0.3}, 0.5)};
                const Timeline timeline = bake(world);
                ASSERT_GT(count_events(timeline, EventKind::impact), 8);
                EXPECT_LT(largest_energy_rise(timeline), 1e-9)
                    << static_cast<int>(model) << " " << hop << " " << speed;
            }
        }
    }
}

TEST(Energy_WithoutLosses, IsConservedInABreak) {
    for (const double speed : {1.5, 6.0, 12.0}) {
        WorldDescription world = walled_world(6);
        world.bodies = nine_ball_world(3).bodies;
        world.contact_law.ball_ball = {1, 0, BallFriction::constant};
        world.contact_law.ball_cushion = {CushionModel::mirror, 1, 0};
        world.contact_law.ball_cloth = {0, 0, 0, 1};
        world.bodies[0].velocity = {speed, -0.12 * speed, 0};
        const Timeline timeline = bake(world);
        ASSERT_GT(count_events(timeline, EventKind::impact), 30);
        const double before = timeline.energy.front().kinetic;
        for (const EnergySample& sample : timeline.energy) {
            EXPECT_NEAR(sample.kinetic / before, 1, 1e-7) << speed << " " << sample.time;
        }
    }
}

}  // namespace
}  // namespace carom::sim::test
