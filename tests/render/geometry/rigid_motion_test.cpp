#include "render/geometry/rigid_motion.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/timeline/rotation.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

sim::Key key(double time, const Vec3& position, const Vec3& velocity) {
    sim::Key k;
    k.time = time;
    k.position = position;
    k.velocity_in = velocity;
    k.velocity_out = velocity;
    return k;
}

double angle_to(const Imath::Quatf& q, const Quat& expected) {
    return sim::angle_between(Quat(q).normalized(), expected);
}

/// A ball that hits a cushion at 0.51 s, with decreasing spin.
sim::Track bouncing() {
    sim::Key a = key(0, Vec3(-1, 0, 0.03), Vec3(2, 0.5, 0));
    sim::Key b = key(0.51, Vec3(0.01, 0.26, 0.03), Vec3(1.9, 0.5, 0));
    sim::Key c = key(1, Vec3(-0.6, 0.5, 0.03), Vec3(-1.1, 0.45, 0));
    b.velocity_out = Vec3(-1.5, 0.5, 0);
    a.angular_velocity_out = Vec3(3, 70, 20);
    b.angular_velocity_in = Vec3(1, 60, 18);
    b.angular_velocity_out = Vec3(10, -20, 40);
    c.angular_velocity_in = Vec3(5, -40, 30);
    b.orientation = Quat(0.3, 0.4, 0.5, -0.2).normalized();
    c.orientation = Quat(-0.1, 0.7, 0.2, 0.4).normalized();
    return sim::Track("cue", {a, b, c});
}

TEST(RigidMotion, PathWithImpact_IsTheTracksOwn) {
    const sim::Track track = bouncing();
    const double open = 0.5;
    const double close = 0.52;
    const RigidMotion motion(track, open, close);
    ASSERT_EQ(motion.path().size(), 2u);
    EXPECT_NEAR(motion.path()[0].end, 0.5f, 1e-6f);
    EXPECT_EQ(motion.path()[0].end, motion.path()[1].start);
    for (int i = 0; i <= 1000; ++i) {
        const float time = static_cast<float>(i) / 1000;
        const double scene_time = open + (close - open) * static_cast<double>(time);
        const Vec3 exact = track.sample(scene_time).position;
        ASSERT_NEAR((Vec3(motion.position(time)) - exact).length(), 0, 2e-7);
        ASSERT_LE(angle_to(motion.world_from_body(time), track.sample(scene_time).orientation),
                  1e-4);
    }
}

TEST(RigidMotion, BallThatIsPutElsewhere_IsAtOneOfTheTwoPlaces) {
    sim::Key stop = key(0.51, Vec3(0, 0, 0.03), Vec3(1, 0, 0));
    stop.velocity_out = Vec3(0, 0, 0);
    const Vec3 spot(1, 0.5, 0.03);
    const sim::Track track("black", {key(0.5, Vec3(-0.01, 0, 0.03), Vec3(1, 0, 0)), stop,
                                     key(sim::time_after_jump(0.51), spot, Vec3(0, 0, 0)),
                                     key(1, spot, Vec3(0, 0, 0))});
    const RigidMotion motion(track, 0.5, 0.52);
    for (int i = 0; i <= 1000; ++i) {
        const Vec3 position(motion.position(static_cast<float>(i) / 1000));
        const bool is_before = (position - Vec3(-0.005, 0, 0.03)).length() < 0.00501;
        ASSERT_TRUE(is_before || position == Vec3(V3f(spot))) << i;
        ASSERT_TRUE(is_before == (i < 500) || i == 500) << i;
    }
    EXPECT_LE(motion.position_bounds().min.x, -0.01F);
    EXPECT_GE(motion.position_bounds().max.x, 1.0F);
}

TEST(RigidMotion, LongShutterManyTurns_OrientationWithinTolerance) {
    const sim::Track track = bouncing();
    const RigidMotion motion(track, -0.2, 1.3);
    for (int i = 0; i <= 5000; ++i) {
        const float time = static_cast<float>(i) / 5000;
        const double scene_time = -0.2 + 1.5 * static_cast<double>(time);
        // A time in float is known to 6e-8 of the shutter: 1e-7 s at 70 rad/s.
        ASSERT_LE(angle_to(motion.world_from_body(time), track.sample(scene_time).orientation),
                  1e-4)
            << scene_time;
    }
}

TEST(RigidMotion, WholeTurnsBetweenKeys_AreNotMissed) {
    // Exactly two turns between keys: the poses at ends and middle are the same.
    sim::Key a = key(0, Vec3(0), Vec3(0));
    sim::Key b = key(1, Vec3(0), Vec3(0));
    const Vec3 rate(0, 0, 4 * std::numbers::pi);
    a.angular_velocity_out = rate;
    b.angular_velocity_in = rate;
    const RigidMotion motion(sim::Track("top", {a, b}), 0, 1);
    EXPECT_FALSE(motion.is_static());
    const V3f x = rotate(motion.world_from_body(0.125f), V3f(1, 0, 0));
    EXPECT_NEAR((x - V3f(0, 1, 0)).length(), 0, 1e-4);
}

TEST(RigidMotion, RestingObject_IsStaticAndOnePiece) {
    const sim::Key a = key(0, Vec3(1, 2, 3), Vec3(0));
    const sim::Key b = key(1, Vec3(1, 2, 3), Vec3(0));
    const sim::Key c = key(2, Vec3(1, 2, 3), Vec3(0));
    const RigidMotion motion(sim::Track("one", {a, b, c}), 0.5, 3);
    EXPECT_TRUE(motion.is_static());
    EXPECT_EQ(motion.path().size(), 1u);
    EXPECT_EQ(motion.position(0.7f), V3f(1, 2, 3));
}

TEST(RigidMotion, ZeroLengthShutter_StandsStill) {
    const sim::Track track = bouncing();
    for (const double time : {0.3, 0.51, -1.0, 5.0}) {
        const RigidMotion motion(track, time, time);
        EXPECT_TRUE(motion.is_static());
        EXPECT_EQ(motion.position(0), motion.position(0.9f));
        EXPECT_EQ(motion.position(0.4f), V3f(track.sample(time).position));
        EXPECT_LE(angle_to(motion.world_from_body(0.5f), track.sample(time).orientation), 1e-6);
    }
}

TEST(RigidMotion, VeryShortSegment_StaysOnThePath) {
    // Two impacts 1e-7 s apart inside one shutter.
    sim::Key a = key(0, Vec3(0), Vec3(5, 0, 0));
    sim::Key b = key(0.01, Vec3(0.05, 0, 0), Vec3(5, 0, 0));
    sim::Key c = key(0.0100001, Vec3(0.0500001, 0, 0), Vec3(1, 0, 0));
    sim::Key d = key(0.02, Vec3(0.06, 0, 0), Vec3(1, 1, 0));
    b.velocity_out = Vec3(1, 0, 0);
    c.velocity_out = Vec3(0.9, 0.2, 0);
    const sim::Track track("fast", {a, b, c, d});
    const RigidMotion motion(track, 0, 0.02);
    for (int i = 0; i <= 10'000; ++i) {
        const float time = static_cast<float>(i) / 10'000;
        const Vec3 exact = track.sample(0.02 * static_cast<double>(time)).position;
        ASSERT_NEAR((Vec3(motion.position(time)) - exact).length(), 0, 2e-7) << time;
    }
}

TEST(RigidMotion, Bounds_ContainEveryPosition) {
    test::TestRandom random(4);
    for (int repeat = 0; repeat < 50; ++repeat) {
        std::vector<sim::Key> keys;
        for (int k = 0; k < 4; ++k) {
            const double x = static_cast<double>(random.between(-2, 2));
            const double v = static_cast<double>(random.between(-9, 9));
            keys.push_back(key(0.1 * k, Vec3(x, -x, 1), Vec3(v, x, -v)));
        }
        const RigidMotion motion(sim::Track("wild", keys), 0.03, 0.27);
        for (int i = 0; i <= 200; ++i) {
            ASSERT_TRUE(
                motion.position_bounds().intersects(motion.position(static_cast<float>(i) / 200)));
        }
    }
}

}  // namespace
}  // namespace carom::render
