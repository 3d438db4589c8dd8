#include "pipeline/export/linear_keys.h"

#include <cmath>

#include <gmock/gmock.h>

#include "core/error.h"
#include "sim/timeline/rotation.h"

namespace carom::pipeline {
namespace {

sim::Key key(double time, const Vec3& position, const Vec3& velocity,
             const Vec3& spin = {0, 0, 0}) {
    sim::Key key;
    key.time = time;
    key.position = position;
    key.velocity_in = key.velocity_out = velocity;
    key.angular_velocity_in = key.angular_velocity_out = spin;
    return key;
}

/// The pose that a program with linear interpolation and slerp would show.
Pose interpolated_pose(const LinearKeys& keys, double time) {
    std::size_t i = 1;
    while (i + 1 < keys.size() && keys.times[i] < time) {
        ++i;
    }
    const double s = (time - keys.times[i - 1]) / (keys.times[i] - keys.times[i - 1]);
    return {
        keys.positions[i - 1] + s * (keys.positions[i] - keys.positions[i - 1]),
        Imath::slerpShortestArc(keys.orientations[i - 1], keys.orientations[i], s).normalized()};
}

TEST(LinearKeys, ObjectAtRest_HasConstantKeys) {
    const sim::Track track("ball", {key(0, {1, 2, 3}, {0, 0, 0}), key(5, {1, 2, 3}, {0, 0, 0})});
    const LinearKeys keys = linear_keys(track, 100);
    EXPECT_EQ(keys.size(), 2U);
    EXPECT_TRUE(keys.is_constant());
}

TEST(LinearKeys, ManyTurnsBetweenTwoKeys_AreKept) {
    // 20 turns within a second, with decreasing speed.
    const Vec3 fast(0, 0, 80 * std::acos(-1.0));
    const sim::Track track(
        "top", {key(0, {0, 0, 0}, {0, 0, 0}, fast), key(1, {0, 0, 0}, {0, 0, 0}, {0, 0, 0})});
    const LinearKeys keys = linear_keys(track, 10000);
    EXPECT_FALSE(keys.is_constant());
    double turned = 0;
    for (std::size_t i = 1; i < keys.size(); ++i) {
        const Vec3 turn = sim::rotation_vector(keys.orientations[i] * ~keys.orientations[i - 1]);
        EXPECT_LE(turn.length(), 0.7 + 1e-9);
        EXPECT_GE(keys.orientations[i] ^ keys.orientations[i - 1], 0);
        turned += turn.z;
    }
    EXPECT_NEAR(turned, 40 * std::acos(-1.0), 1e-6);
}

TEST(LinearKeys, Curve_IsFollowedWithinTheTolerance) {
    const sim::Track track("ball", {key(0, {0, 0, 0}, {3, 1, 0}, {40, 0, 10}),
                                    key(0.7, {1, 1, 0}, {-1, 2, 3}, {0, 50, -30})});
    const LinearKeys keys = linear_keys(track, 100000);
    for (int i = 0; i <= 5000; ++i) {
        const double time = 0.7 * i / 5000;
        const MotionState exact = track.sample(time);
        const Pose shown = interpolated_pose(keys, time);
        ASSERT_LT((exact.position - shown.position).length(), 6e-5) << time;
        ASSERT_LT(sim::angle_between(exact.orientation, shown.orientation), 2.5e-3) << time;
    }
}

TEST(LinearKeys, Impact_KeepsItsVelocityJump) {
    sim::Key impact = key(0.3, {0.3, 0, 0}, {1, 0, 0});
    impact.velocity_out = {0, 1, 0};
    const sim::Track track(
        "ball", {key(0, {0, 0, 0}, {1, 0, 0}), impact, key(1, {0.3, 0.7, 0}, {0, 1, 0})});
    const LinearKeys keys = linear_keys(track, 100);
    EXPECT_THAT(keys.times, ::testing::ElementsAre(0, 0.3, 1));
    EXPECT_EQ(keys.positions[1], Vec3(0.3, 0, 0));
}

TEST(LinearKeys, TooManyKeys_AreRefusedWithTheObjectsName) {
    const sim::Track track("top", {key(0, {0, 0, 0}, {0, 0, 0}, {0, 0, 500}),
                                   key(1, {0, 0, 0}, {0, 0, 0}, {0, 0, 500})});
    EXPECT_THAT([&] { (void)linear_keys(track, 50); },
                ::testing::ThrowsMessage<Error>(
                    ::testing::HasSubstr("the motion of 'top' needs more than 50 keys")));
}

TEST(LinearKeys, Jump_IsBetweenTwoNeighbouringTimes) {
    sim::Key stop = key(1, {2, 0, 0}, {2, 0, 0});
    stop.velocity_out = {0, 0, 0};
    const double landed = sim::time_after_jump(1);
    const sim::Track track("ball",
                           {key(0, {0, 0, 0}, {2, 0, 0}), stop, key(landed, {0, 1, 0}, {0, 0, 0}),
                            key(2, {0, 1, 0}, {0, 0, 0})});
    const LinearKeys keys = linear_keys(track, 100);
    EXPECT_EQ(keys.times, (std::vector<double>{0, 1, landed, 2}));
    EXPECT_EQ(keys.positions, (std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(keys.jumps, std::vector<std::size_t>{2});
}

TEST(LinearKeys, KeysFromATime_ShowTheSameFromThenOn) {
    LinearKeys keys;
    keys.add(-2, {0, 0, 0}, Quat());
    keys.add(1, {3, 0, 0}, Quat(std::cos(0.3), 0, 0, std::sin(0.3)));
    keys.jumps.push_back(2);
    keys.add(1.5, {9, 0, 0}, Quat());
    keys.add(2, {9, 1, 0}, Quat());
    const LinearKeys rest = keys.from(0);
    EXPECT_EQ(rest.times, (std::vector<double>{0, 1, 1.5, 2}));
    EXPECT_NEAR((rest.positions[0] - Vec3(2, 0, 0)).length(), 0, 1e-15);
    EXPECT_NEAR(sim::angle_between(rest.orientations[0], Quat()), 0.4, 1e-12);
    EXPECT_EQ(rest.jumps, std::vector<std::size_t>{2});
    EXPECT_EQ(keys.from(-3).times, keys.times);
    EXPECT_EQ(keys.from(1).times, (std::vector<double>{1, 1.5, 2}));
    EXPECT_EQ(keys.from(1).jumps, std::vector<std::size_t>{1});
    // Before a jump the object stays where it was.
    EXPECT_EQ(keys.from(1.25).positions.front(), Vec3(3, 0, 0));
    EXPECT_EQ(keys.from(1.25).jumps, std::vector<std::size_t>{1});
    EXPECT_EQ(keys.from(1.5).jumps, std::vector<std::size_t>{});
    EXPECT_EQ(keys.from(3).positions, (std::vector<Vec3>{{9, 1, 0}}));
}

}  // namespace
}  // namespace carom::pipeline
