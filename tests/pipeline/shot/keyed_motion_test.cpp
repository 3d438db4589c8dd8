// Compares keyed motions with closed forms.
#include "pipeline/shot/keyed_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/error.h"
#include "sim/timeline/rotation.h"
#include "sim/timeline/rotation_segment.h"

namespace carom::pipeline {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

MotionKey at(double time, const Vec3& position) {
    MotionKey key;
    key.time = time;
    key.position = position;
    return key;
}

MotionKey first() {
    MotionKey key;
    key.time = 0;
    return key;
}

MotionKey turned(double time, const Vec3& turn) {
    MotionKey key;
    key.time = time;
    key.turn = turn;
    return key;
}

MotionKey rotated(double time, const Vec3& rotation) {
    MotionKey key;
    key.time = time;
    key.rotate = sim::rotation_from_vector(rotation);
    return key;
}

void expect_near(const Vec3& a, const Vec3& b, double bound = 1e-12) {
    EXPECT_LE((a - b).length(), bound) << a << " against " << b;
}

/// Expects the orientation after a rotation about z.
void expect_turned(const sim::Track& track, double time, double degrees) {
    const Quat expected = sim::rotation_from_vector({0, 0, degrees * kDegree});
    EXPECT_LE(sim::angle_between(track.sample(time).orientation, expected), 1e-12) << time;
}

TEST(KeyedMotion, Linear_IsStraightAtConstantSpeed) {
    const sim::Track track =
        keyed_track("a", {{at(1, {0, 0, 0}), at(3, {4, 0, 0}), at(4, {4, 3, 0})}, true});
    expect_near(track.sample(1.5).position, {1, 0, 0});
    expect_near(track.sample(1.5).velocity, {2, 0, 0});
    expect_near(track.sample(3).position, {4, 0, 0});
    expect_near(track.sample(3.25).position, {4, 0.75, 0});
    expect_near(track.sample(3.25).velocity, {0, 3, 0});
}

TEST(KeyedMotion, BeforeAndAfterTheKeys_StandsStill) {
    const sim::Track track = keyed_track("a", {{at(1, {1, 0, 0}), at(2, {2, 0, 0})}, true});
    EXPECT_EQ(track.sample(0).position, Vec3(1, 0, 0));
    EXPECT_EQ(track.sample(9).position, Vec3(2, 0, 0));
    EXPECT_EQ(track.sample(9).velocity, Vec3(0, 0, 0));
}

TEST(KeyedMotion, SmoothPair_StartsAndStopsAtRest) {
    const sim::Track track = keyed_track("a", {{at(0, {0, 0, 0}), at(2, {1, 0, 0})}});
    for (const double s : {0.0, 0.1, 0.25, 0.5, 0.8, 1.0}) {
        expect_near(track.sample(2 * s).position, {s * s * (3 - 2 * s), 0, 0});
        expect_near(track.sample(2 * s).velocity, {3 * s * (1 - s), 0, 0});
    }
}

TEST(KeyedMotion, SmoothInnerKey_HasTheMeanVelocityOfItsNeighbours) {
    const sim::Track track =
        keyed_track("a", {{at(0, {0, 0, 0}), at(1, {1, 0, 0}), at(3, {1, 6, 0})}});
    const Vec3 v(1.0 / 3, 2, 0);
    expect_near(track.sample(1).position, {1, 0, 0});
    expect_near(track.sample(1).velocity, v);
    // The cubic Hermite curve half-way: (p0 + p1) / 2 + h (v0 - v1) / 8.
    expect_near(track.sample(0.5).position, Vec3(0.5, 0, 0) - v / 8);
    expect_near(track.sample(2).position, Vec3(1, 3, 0) + v / 4);
    for (const sim::Key& key : track.keys()) {
        EXPECT_FALSE(key.is_break());
    }
}

TEST(KeyedMotion, GivenVelocity_IsKept) {
    KeyedMotion motion{{at(0, {0, 0, 0}), at(1, {1, 0, 0})}};
    motion.keys[0].velocity = Vec3(2, 0, 0);
    const sim::Track track = keyed_track("a", motion);  // constant deceleration from 2 m/s to 0
    for (const double t : {0.0, 0.3, 0.7, 1.0}) {
        expect_near(track.sample(t).position, {2 * t - t * t, 0, 0});
    }
}

TEST(KeyedMotion, Pause_DoesNotDrift) {
    const sim::Track track = keyed_track(
        "a", {{at(0, {0, 0, 0}), at(1, {1, 0, 0}), at(2, {1, 0, 0}), at(3, {5, 0, 0})}});
    for (const double time : {1.0, 1.2, 1.5, 1.9, 2.0}) {
        EXPECT_EQ(track.sample(time).position, Vec3(1, 0, 0));
    }
}

TEST(KeyedMotion, MissingValues_AreThoseOfThePreviousKeyOrTheStart) {
    const Pose start{{1, 2, 3}, sim::rotation_from_vector({0, 0, 30 * kDegree})};
    const sim::Track track = keyed_track(
        "a", {{first(), turned(1, {0, 0, 60 * kDegree}), at(2, {9, 2, 3})}, true}, start);
    EXPECT_EQ(track.sample(0).position, Vec3(1, 2, 3));
    EXPECT_EQ(track.sample(1).position, Vec3(1, 2, 3));
    expect_turned(track, 0, 30);
    expect_turned(track, 0.5, 60);
    expect_turned(track, 2, 90);
}

TEST(KeyedMotion, LinearTurn_MayHaveManyRevolutions) {
    const sim::Track track = keyed_track("a", {{first(), turned(2, {0, 0, 900 * kDegree})}, true});
    for (const double s : {0.0, 0.1, 0.5, 0.77, 1.0}) {
        expect_turned(track, 2 * s, 900 * s);
    }
}

TEST(KeyedMotion, SmoothTurnOfManyRevolutions_AcceleratesAndDeceleratesEvenly) {
    for (const double degrees : {720.0, -270.0, 190.0}) {
        const sim::Track track =
            keyed_track("a", {{first(), turned(2, {0, 0, degrees * kDegree})}});
        for (const double s : {0.0, 0.1, 0.25, 0.5}) {
            expect_turned(track, 2 * s, degrees * 2 * s * s);
            expect_turned(track, 2 - 2 * s, degrees * (1 - 2 * s * s));
        }
        EXPECT_EQ(track.sample(0).angular_velocity, Vec3(0, 0, 0));
        expect_near(track.sample(1).angular_velocity, {0, 0, degrees * kDegree});
    }
}

TEST(KeyedMotion, Rotation_TakesTheSmallerAngle) {
    const sim::Track track =
        keyed_track("a", {{rotated(0, {0, 0, 0}), rotated(1, {0, 0, 270 * kDegree})}, true});
    expect_turned(track, 0.5, -45);
}

TEST(KeyedMotion, SmoothTurnsAboutOneAxis_HaveTheirMeanVelocityAtTheInnerKey) {
    const sim::Track track = keyed_track(
        "a", {{first(), turned(1, {0, 0, 400 * kDegree}), turned(3, {0, 0, 500 * kDegree})}});
    expect_near(track.sample(1).angular_velocity, {0, 0, 300 * kDegree});
    expect_turned(track, 1, 400);
    expect_turned(track, 3, 900);
}

/// The largest rotation error that a track would have to distribute between two keys because its
/// angular velocities do not lead from one to the other, rad.
double largest_rotation_error(const sim::Track& track) {
    double largest = 0;
    for (std::size_t i = 1; i < track.keys().size(); ++i) {
        const sim::Key& from = track.keys()[i - 1];
        const sim::Key& to = track.keys()[i];
        const sim::RotationSegment rotation(from.angular_velocity_out, to.angular_velocity_in,
                                            to.time - from.time);
        const Quat end = rotation.advance(from.orientation, 0, rotation.substeps());
        largest = std::max(largest, sim::angle_between(end, to.orientation));
    }
    return largest;
}

TEST(KeyedMotion, SmoothTurnsAboutChangingAxes_HaveContinuousVelocity) {
    const sim::Track track =
        keyed_track("a", {{rotated(0, {0, 0, 0}), rotated(1, {1.2, 0.3, 0}),
                           rotated(1.7, {0.4, -0.5, 1.4}), rotated(3, {-1, 0.5, 2})}});
    for (const sim::Key& key : track.keys()) {
        EXPECT_FALSE(key.is_break());
    }
    EXPECT_LE(largest_rotation_error(track), 1e-12);
}

TEST(KeyedMotion, SmoothTurnsAboutAnyAxes_LeadToTheirKeys) {
    std::mt19937 numbers(7);
    const auto next = [&] { return 2 * (static_cast<double>(numbers()) / 4294967295.0) - 1; };
    for (int i = 0; i < 200; ++i) {
        KeyedMotion motion;
        for (const double time : {0.0, 0.5, 2.0, 2.5, 4.0}) {
            motion.keys.push_back(rotated(time, 1.8 * Vec3{next(), next(), next()}));
        }
        EXPECT_LE(largest_rotation_error(keyed_track("a", motion)), 1e-12) << i;
    }
}

TEST(KeyedMotion, LongTurnsAboutDifferentAxes_StopAtTheKey) {
    const sim::Track track =
        keyed_track("a", {{first(), turned(1, {0, 0, 720 * kDegree}), turned(2, {9, 0, 0})}});
    EXPECT_EQ(track.sample(1).angular_velocity, Vec3(0, 0, 0));
    expect_turned(track, 0.25, 90);
    EXPECT_LE(
        sim::angle_between(track.sample(1.5).orientation, sim::rotation_from_vector({4.5, 0, 0})),
        1e-12);
}

}  // namespace
}  // namespace carom::pipeline
