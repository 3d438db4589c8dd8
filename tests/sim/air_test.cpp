// Balls in the air: exact parabolas, bounces and landings.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "shots.h"

namespace carom::sim::test {
namespace {

Body ball_in_air(const Vec3& position, const Vec3& velocity, const Vec3& spin = {0, 0, 0}) {
    Body body = ball("cue", 0, 0, velocity, spin);
    body.pose.position = position;
    return body;
}

TEST(BallInAir_DroppedOnSlate, BouncesToTheSquareOfRestitution) {
    for (const double e : {0.3, 0.5, 0.8}) {
        WorldDescription world = cloth_world(3);
        world.contact_law.ball_cloth.restitution = e;
        world.bodies = {ball_in_air({0, 0, kRadius + 0.5}, {0, 0, 0})};
        const Timeline timeline = bake(world);
        double impact = std::sqrt(2 * 0.5 / kGravity);
        double speed = kGravity * impact;
        for (int bounce = 0; bounce < 4; ++bounce) {
            speed *= e;
            const double apex = impact + speed / kGravity;
            const double height = state_at(timeline, "cue", apex).position.z - kRadius;
            EXPECT_NEAR(height, speed * speed / (2 * kGravity), 1e-12) << e << " " << bounce;
            impact += 2 * speed / kGravity;
        }
        EXPECT_NE(find_event(timeline, EventKind::resting, "cue"), nullptr);
        EXPECT_EQ(state_at(timeline, "cue", 3).position.z, kRadius);
    }
}

TEST(BallInAir_Thrown, FollowsTheParabolaAndKeepsItsSpin) {
    WorldDescription world = cloth_world(1);
    const Vec3 spin(10, 20, -30);
    world.bodies = {ball_in_air({0, 0, 0.5}, {2, 1, 1.5}, spin)};
    const Timeline timeline = bake(world);
    for (double t = 0; t < 0.5; t += 0.03) {
        const MotionState state = state_at(timeline, "cue", t);
        const Vec3 expected(2 * t, t, 0.5 + 1.5 * t - 0.5 * kGravity * t * t);
        EXPECT_NEAR((state.position - expected).length(), 0, 1e-12);
        EXPECT_NEAR((state.angular_velocity - spin).length(), 0, 1e-12);
    }
}

TEST(JumpShot_OverABall, ClearsItAndLandsWhereTheParabolaSays) {
    WorldDescription world = cloth_world(3);
    world.bodies = {ball("cue", 0, 0), ball("one", 0.25, 0), ball("two", 3, 0)};
    const double elevation = 40 * std::numbers::pi / 180;
    world.events = {strike_towards("cue", "two", 4, 0, {0, 0}, elevation)};
    std::get<Strike>(world.events[0].action).tip_restitution = 1;
    const Timeline timeline = bake(world);
    EXPECT_EQ(find_event(timeline, EventKind::impact, "cue", "one"), nullptr);
    // The strike, then the impact with the slate, which returns the fraction e of the descent;
    // friction reduces the forward speed (by at most mu (1 + e) of the descent and 2/7 of the
    // slip).
    const double launch_speed = 2 * 4 / (1 + kMass / 0.567);
    const double descent = launch_speed * std::sin(elevation);
    const double level = launch_speed * std::cos(elevation);
    const double rise = 0.5 * descent;
    const double forward = level - std::min(0.2 * 1.5 * descent, 2.0 / 7 * level);
    std::vector<const Event*> slate;
    for (const Event& event : timeline.events) {
        if (event.kind == EventKind::impact && event.b == "cloth") {
            slate.push_back(&event);
        }
    }
    ASSERT_GE(slate.size(), 2U);
    EXPECT_EQ(slate[0]->time, 0);
    EXPECT_NEAR(slate[1]->time, 2 * rise / kGravity, 1e-12);
    EXPECT_NEAR(slate[1]->place.x, forward * 2 * rise / kGravity, 1e-11);
    // It ends exactly on the cloth.
    const MotionState end = state_at(timeline, "cue", 3);
    EXPECT_EQ(end.position.z, kRadius);
    EXPECT_EQ(end.velocity.z, 0);
}

TEST(JumpShot_Landing, HasNoDiscontinuity) {
    WorldDescription world = cloth_world(3);
    world.bodies = {ball("cue", 0, 0), ball("two", 9, 0)};
    world.events = {strike_towards("cue", "two", 3, 0, {0.1, -0.2}, 0.5)};
    const Timeline timeline = bake(world);
    const Track& track = *timeline.find("cue");
    Vec3 last = track.sample(0).position;
    for (double t = 1e-4; t < 3; t += 1e-4) {
        const MotionState state = track.sample(t);
        const double step = (state.position - last).length();
        EXPECT_LT(step, 5.2 * 1e-4) << t;  // never faster than the strike
        EXPECT_GE(state.position.z, kRadius - 1e-9) << t;
        last = state.position;
    }
}

TEST(BallInAir_OnAnotherBall, BouncesOffIt) {
    WorldDescription world = cloth_world(2);
    world.bodies = {ball_in_air({0.004, 0, 0.3}, {0, 0, 0}), ball("one", 0, 0)};
    const Timeline timeline = bake(world);
    const Event* impact = find_event(timeline, EventKind::impact, "cue", "one");
    ASSERT_NE(impact, nullptr);
    EXPECT_GT(impact->normal.z, 0.9);
    // Both balls end on the cloth and do not overlap.
    const Vec3 a = state_at(timeline, "cue", 2).position;
    const Vec3 b = state_at(timeline, "one", 2).position;
    EXPECT_NEAR(a.z, kRadius, 1e-9);
    EXPECT_NEAR(b.z, kRadius, 1e-9);
    EXPECT_GE((a - b).length(), 2 * kRadius - 1e-6);
}

TEST(Ball_DrivenOffTheTable, LandsOnTheFloor) {
    WorldDescription world = walled_world(4);
    world.floor_height = -world.table->height;
    world.bodies = {ball("cue", 0.9, 0)};
    SetVelocity velocity;
    velocity.linear = Vec3(4, 0.3, 2.5);
    ForceEvent event;
    event.object = "cue";
    event.action = velocity;
    world.events = {event};
    const Timeline timeline = bake(world);
    const Event* off = find_event(timeline, EventKind::off_table, "cue");
    ASSERT_NE(off, nullptr);
    EXPECT_GT(off->place.x, 1.27);
    EXPECT_NE(find_event(timeline, EventKind::impact, "cue", "floor"), nullptr);
    EXPECT_NEAR(state_at(timeline, "cue", 4).position.z, kRadius - world.table->height, 1e-9);
}

TEST(Hop_WhenEnabled, LiftsTheBallOffAfterACushion) {
    WorldDescription world = walled_world(2);
    const Vec3 velocity(4, 0, 0);
    world.bodies = {ball("cue", 0.5, 0, velocity, {0, -100, 0})};
    EXPECT_EQ(find_event(bake(world), EventKind::airborne, "cue"), nullptr);
    world.contact_law.hop = true;
    const Timeline timeline = bake(world);
    const Event* hop = find_event(timeline, EventKind::airborne, "cue");
    ASSERT_NE(hop, nullptr);
    EXPECT_EQ(state_at(timeline, "cue", 2).position.z, kRadius);
}

TEST(TiltedGravity_BallOnCloth, RollsDownhill) {
    WorldDescription world = cloth_world(1);
    const double angle = 0.05;
    world.gravity = {kGravity * std::sin(angle), 0, -kGravity * std::cos(angle)};
    world.contact_law.ball_cloth.rolling_friction = 0;
    world.bodies = {ball("cue", 0, 0)};
    const MotionState end = state_at(bake(world), "cue", 1);
    // A rolling ball accelerates at 5/7 g sin.
    EXPECT_NEAR(end.velocity.x, 5.0 / 7 * kGravity * std::sin(angle), 2e-3);
    EXPECT_NEAR(end.position.z, kRadius, 2e-5);
}

}  // namespace
}  // namespace carom::sim::test
