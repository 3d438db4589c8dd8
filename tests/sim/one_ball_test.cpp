// Complete bakes of one ball, compared with the closed forms.
#include <cmath>

#include <gtest/gtest.h>

#include "shots.h"
#include "sim/motion/cloth_motion.h"

namespace carom::sim::test {
namespace {

TEST(OneBall_StunShot, EndsByTheFormulas) {
    for (const double speed : {0.3, 2.0, 6.0}) {
        WorldDescription world = cloth_world(60);
        world.bodies = {ball("cue", 0.1, -0.2, {speed, 0, 0})};
        const Timeline timeline = bake(world);
        const Event* rolling = find_event(timeline, EventKind::rolling, "cue");
        ASSERT_NE(rolling, nullptr);
        EXPECT_NEAR(rolling->time, 2 * speed / (7 * 0.2 * kGravity), 1e-12);
        EXPECT_NEAR(rolling->place.x - 0.1, 12 * speed * speed / (49 * 0.2 * kGravity), 1e-12);
        const Event* resting = find_event(timeline, EventKind::resting, "cue");
        ASSERT_NE(resting, nullptr);
        const double rolled = speed * speed * 25 / 49 / (2 * 0.01 * kGravity);
        EXPECT_NEAR(resting->place.x, rolling->place.x + rolled, 1e-11);
        EXPECT_NEAR(resting->place.y, -0.2, 1e-15);
        EXPECT_EQ(state_at(timeline, "cue", 60).velocity, Vec3(0, 0, 0));
    }
}

TEST(OneBall_Masse, FollowsTheParabola) {
    WorldDescription world = cloth_world(3);
    const Vec3 velocity(1.5, 0.4, 0);
    const Vec3 spin(40, -70, 90);
    world.bodies = {ball("cue", 0, 0, velocity, spin)};
    const Timeline timeline = bake(world);
    MotionState start;
    start.velocity = velocity;
    start.angular_velocity = spin;
    const Vec3 slip = slip_velocity(start, kRadius);
    const double end = 2 * slip.length() / (7 * 0.2 * kGravity);
    for (double t = 0; t < end; t += 0.01) {
        const Vec3 expected = velocity * t - slip / slip.length() * (0.5 * 0.2 * kGravity * t * t);
        const Vec3 p = state_at(timeline, "cue", t).position;
        EXPECT_NEAR((Vec2(p.x, p.y) - Vec2(expected.x, expected.y)).length(), 0, 1e-12) << t;
        EXPECT_NEAR(p.z, kRadius, 1e-15);
    }
}

TEST(OneBall_RollingTenSeconds, TurnsByItsPathOverItsRadius) {
    WorldDescription world = cloth_world(10);
    const Vec3 velocity(1.2, 0, 0);
    world.bodies = {ball("cue", 0, 0, velocity, rolling_spin(velocity))};
    const Timeline timeline = bake(world);
    for (const double t : {0.1, 3.3, 10.0}) {
        const double path = 1.2 * t - 0.5 * 0.01 * kGravity * t * t;
        const double angle = path / kRadius;
        const Quat q = state_at(timeline, "cue", t).orientation;
        const double cosine = q.r * std::cos(angle / 2) + q.v.y * std::sin(angle / 2);
        EXPECT_NEAR(std::abs(cosine), 1, 1e-12) << t;
    }
}

TEST(OneBall_VerticalSpin, DecaysToRest) {
    WorldDescription world = cloth_world(10);
    world.bodies = {ball("cue", 0, 0, {0, 0, 0}, {0, 0, 30})};
    const Timeline timeline = bake(world);
    const double rate = 2.5 * 0.0127 * kGravity / kRadius;
    EXPECT_NEAR(state_at(timeline, "cue", 1).angular_velocity.z, 30 - rate, 1e-10);
    EXPECT_NEAR(find_event(timeline, EventKind::resting, "cue")->time, 30 / rate, 1e-12);
}

TEST(OneBall_StepLength, DoesNotMatter) {
    std::vector<MotionState> ends;
    for (const double step : {1.0 / 60, 1.0 / 240, 1.0 / 1000}) {
        WorldDescription world = cloth_world(4);
        world.step = step;
        world.bodies = {ball("cue", 0, 0, {2, 1, 0}, {30, -50, 20})};
        ends.push_back(state_at(bake(world), "cue", 4));
    }
    for (const MotionState& end : ends) {
        EXPECT_NEAR((end.position - ends[0].position).length(), 0, 1e-13);
    }
}

TEST(OneBall_KeysOfAStunShot, AreOnlyThoseOfItsSegments) {
    WorldDescription world = cloth_world(60);
    world.bodies = {ball("cue", 0, 0, {2, 0, 0})};
    // Start, rolling, resting, end.
    EXPECT_EQ(bake(world).find("cue")->keys().size(), 4U);
}

}  // namespace
}  // namespace carom::sim::test
