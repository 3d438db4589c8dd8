#include "sim/timeline/track.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "sim/timeline/rotation.h"
#include "timeline_helpers.h"

namespace carom::sim {
namespace {

using test::smooth_key;

TEST(Track, AtKeys_SampleIsExact) {
    const Track track = test::random_track(1, 20);
    for (const Key& key : track.keys()) {
        const MotionState state = track.sample(key.time);
        EXPECT_EQ(state.position, key.position);
        EXPECT_EQ(state.orientation, key.orientation);
        EXPECT_EQ(state.velocity, key.velocity_out);
        EXPECT_EQ(state.angular_velocity, key.angular_velocity_out);
    }
}

TEST(Track, BeforeFirstAndAfterLast_HoldsEndPoseAtRest) {
    const Track track = test::random_track(2, 5);
    const Key& first = track.keys().front();
    const Key& last = track.keys().back();
    const MotionState before = track.sample(first.time - 1e-9);
    EXPECT_EQ(before, (MotionState{first.position, first.orientation}));
    EXPECT_EQ(track.sample(-1e9), before);
    const MotionState after = track.sample(last.time + 1e-9);
    EXPECT_EQ(after, (MotionState{last.position, last.orientation}));
    EXPECT_EQ(track.sample(1e9), after);
}

TEST(Track, BetweenKeys_UniformAccelerationIsExact) {
    // x = 1 + 2 t - 3 t^2 with keys at 0 and 2 s.
    const Track track(
        "ball", {smooth_key(0, {1, 0, 0}, {2, 0, 0}), smooth_key(2, {-7, 0, 0}, {-10, 0, 0})});
    for (const double time : {0.1, 0.5, 1.0, 1.7}) {
        EXPECT_NEAR(track.sample(time).position.x, 1 + 2 * time - 3 * time * time, 1e-14);
        EXPECT_NEAR(track.sample(time).velocity.x, 2 - 6 * time, 1e-14);
    }
}

TEST(Track, BetweenKeys_VelocityIsTheSlopeOfThePath) {
    const Track track = test::random_track(3, 12);
    test::RandomNumbers numbers(3);
    for (int trial = 0; trial < 200; ++trial) {
        const double time = numbers.between(track.keys().front().time, track.keys().back().time);
        const double step = 1e-6;
        // Not across a key.
        bool is_near_key = false;
        for (const Key& key : track.keys()) {
            is_near_key = is_near_key || std::abs(key.time - time) < 2 * step;
        }
        if (is_near_key) {
            continue;
        }
        const Vec3 slope =
            (track.sample(time + step).position - track.sample(time - step).position) / (2 * step);
        EXPECT_NEAR((track.sample(time).velocity - slope).length(), 0, 1e-5);
    }
}

TEST(Track, SeekInAnyOrder_GivesTheSameAnswer) {
    const Track track = test::random_track(4, 30);
    test::RandomNumbers numbers(4);
    std::vector<double> times;
    for (int index = 0; index < 300; ++index) {
        times.push_back(numbers.between(0, 7));
    }
    std::vector<MotionState> forward;
    for (const double time : times) {
        forward.push_back(track.sample(time));
    }
    for (std::size_t index = times.size(); index-- > 0;) {
        EXPECT_EQ(track.sample(times[index]), forward[index]);
    }
}

TEST(Track, Break_KeepsTheCornerAndReturnsTheOutgoingVelocity) {
    Key impact = smooth_key(1, {1, 0, 0}, {1, 0, 0});
    impact.velocity_out = {-0.5, 0, 0};
    impact.angular_velocity_out = {0, 3, 0};
    const Track track("ball", {smooth_key(0, {0, 0, 0}, {1, 0, 0}), impact,
                               smooth_key(2, {0.5, 0, 0}, {-0.5, 0, 0})});
    EXPECT_EQ(track.sample(1).velocity, Vec3(-0.5, 0, 0));
    EXPECT_EQ(track.sample(1).angular_velocity, Vec3(0, 3, 0));
    for (const double before : {1e-3, 1e-6, 1e-9}) {
        EXPECT_NEAR(track.sample(1 - before).position.x, 1 - before, 1e-15);
        EXPECT_NEAR(track.sample(1 - before).velocity.x, 1, 1e-14);
        EXPECT_NEAR(track.sample(1 + before).position.x, 1 - 0.5 * before, 1e-15);
        EXPECT_NEAR(track.sample(1 + before).velocity.x, -0.5, 1e-14);
    }
}

TEST(Track, OneKey_HoldsForever) {
    const Track track("ball", {smooth_key(3, {1, 2, 3}, {0, 0, 0})});
    EXPECT_EQ(track.sample(2).position, Vec3(1, 2, 3));
    EXPECT_EQ(track.sample(3).position, Vec3(1, 2, 3));
    EXPECT_EQ(track.sample(4).position, Vec3(1, 2, 3));
}

TEST(Track, Orientation_IsContinuousAcrossKeys) {
    const Track track = test::random_track(5, 30);
    for (const Key& key : track.keys()) {
        EXPECT_LT(angle_between(track.sample(key.time - 1e-10).orientation, key.orientation), 1e-6);
        EXPECT_LT(angle_between(track.sample(key.time + 1e-10).orientation, key.orientation), 1e-6);
    }
}

struct BadKeys {
    const char* name;
    std::vector<Key> keys;
    const char* message;
};

class TrackRefusal : public testing::TestWithParam<BadKeys> {};

TEST_P(TrackRefusal, BadKeys_AreNamed) {
    EXPECT_THAT([] { Track("cue", GetParam().keys); },
                testing::ThrowsMessage<Error>(GetParam().message));
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Key kGood = smooth_key(0, {0, 0, 0}, {0, 0, 0});

INSTANTIATE_TEST_SUITE_P(
    Keys, TrackRefusal,
    testing::Values(BadKeys{"none", {}, "track 'cue' has no keys"},
                    BadKeys{
                        "same_time",
                        {kGood, kGood},
                        "track 'cue', key 1: its time is not later than that of the previous key"},
                    BadKeys{"nan_time",
                            {kGood, smooth_key(kNan, {0, 0, 0}, {0, 0, 0})},
                            "track 'cue', key 1: a value is not finite"},
                    BadKeys{"infinite_position",
                            {smooth_key(0, {0, kInfinity, 0}, {0, 0, 0})},
                            "track 'cue', key 0: a value is not finite"},
                    BadKeys{"nan_spin",
                            {smooth_key(0, {0, 0, 0}, {0, 0, 0}, Quat(), {0, 0, kNan})},
                            "track 'cue', key 0: a value is not finite"},
                    BadKeys{"long_quaternion",
                            {smooth_key(0, {0, 0, 0}, {0, 0, 0}, Quat(1.00001, 0, 0, 0))},
                            "track 'cue', key 0: the orientation is not a unit quaternion"},
                    BadKeys{"endless_turn",
                            {smooth_key(0, {0, 0, 0}, {0, 0, 0}, Quat(), {1e8, 0, 0}),
                             smooth_key(1, {0, 0, 0}, {0, 0, 0}, Quat(), {0, 1e8, 0})},
                            "track 'cue' turns more than 1e6 rad about changing axes"}),
    [](const auto& instance) { return instance.param.name; });

/// Moves along x, is put 1 m aside at 1 s and rests there.
Track track_with_jump() {
    const Vec3 aside(0, 1, 0);
    Key stop = smooth_key(1, {2, 0, 0}, {2, 0, 0});
    stop.velocity_out = {0, 0, 0};
    return Track("ball", {smooth_key(0, {0, 0, 0}, {2, 0, 0}), stop,
                          smooth_key(time_after_jump(1), aside, {0, 0, 0}),
                          smooth_key(3, aside, {0, 0, 0})});
}

TEST(TrackThatJumps, AtAnyTime_IsNeverBetweenThePlaces) {
    const Track track = track_with_jump();
    EXPECT_TRUE(track.jumps_after(1));
    EXPECT_FALSE(track.jumps_after(0));
    EXPECT_FALSE(track.jumps_after(2));
    EXPECT_NEAR(track.sample(std::nextafter(1.0, 0.0)).position.x, 2, 1e-12);
    for (const double time : {1.0, time_after_jump(1), 1.5, 5.0}) {
        EXPECT_EQ(track.sample(time).position, Vec3(0, 1, 0)) << time;
        EXPECT_EQ(track.sample(time).velocity, Vec3(0, 0, 0)) << time;
    }
}

TEST(TrackThatJumps, Segments_EndBeforeItAndBeginAfterIt) {
    const Track track = track_with_jump();
    const std::vector<PathSegment> segments = track.segments(0.5, 2);
    ASSERT_EQ(segments.size(), 2U);
    EXPECT_EQ(segments[0].end, 1);
    EXPECT_EQ(segments[0].p1, Vec3(2, 0, 0));
    EXPECT_EQ(segments[1].start, time_after_jump(1));
    EXPECT_EQ(segments[1].p0, Vec3(0, 1, 0));
    EXPECT_EQ(segments[1].p1, Vec3(0, 1, 0));
    const auto from_jump = track.segments(1, 2);
    ASSERT_EQ(from_jump.size(), 1U);
    EXPECT_EQ(from_jump[0].p0, Vec3(0, 1, 0));
    const auto to_jump = track.segments(0.5, 1);
    ASSERT_EQ(to_jump.size(), 1U);
    EXPECT_EQ(to_jump[0].p1, Vec3(2, 0, 0));
    EXPECT_EQ(track.segments(1, 1)[0].p0, Vec3(0, 1, 0));
    EXPECT_EQ(track.segments(1, time_after_jump(1))[0].p0, Vec3(0, 1, 0));
}

TEST(TrackThatJumps, Bounds_ContainBothPlacesOnlyAcrossTheJump) {
    const Track track = track_with_jump();
    const auto expect_near = [](const Vec3& a, const Vec3& b) {
        EXPECT_NEAR((a - b).length(), 0, 1e-12);
    };
    expect_near(track.position_bounds(1, 2).low, {0, 1, 0});
    expect_near(track.position_bounds(1, 2).high, {0, 1, 0});
    expect_near(track.position_bounds(0.75, 2).low, {0, 0, 0});
    expect_near(track.position_bounds(0.75, 2).high, {2, 1, 0});
}

TEST(TrackThatJumps, WithItsLastKey_RestsWhereItLanded) {
    Key stop = smooth_key(1, {2, 0, 0}, {0, 0, 0});
    const Track track("ball", {stop, smooth_key(time_after_jump(1), {0, 1, 0}, {0, 0, 0})});
    EXPECT_EQ(track.sample(0.5).position, Vec3(2, 0, 0));
    EXPECT_EQ(track.sample(1).position, Vec3(0, 1, 0));
    EXPECT_EQ(track.segments(0, 2).back().p0, Vec3(0, 1, 0));
    EXPECT_EQ(track.segments(0, 2).size(), 2U);
}

TEST(TrackThatJumps, SeveralTimesInOneInstant_LandsAtTheLastPlace) {
    const double second = time_after_jump(1);
    const Track track(
        "ball", {smooth_key(1, {2, 0, 0}, {0, 0, 0}), smooth_key(second, {0, 1, 0}, {0, 0, 0}),
                 smooth_key(time_after_jump(second), {3, 3, 0}, {0, 0, 0})});
    EXPECT_EQ(track.sample(1).position, Vec3(3, 3, 0));
    EXPECT_EQ(track.sample(second).position, Vec3(3, 3, 0));
}

TEST(TrackWithImpactsOneNumberApart, DoesNotJump) {
    const Track track("ball", {smooth_key(1, {2, 0, 0}, {9, 0, 0}),
                               smooth_key(time_after_jump(1), {2 + 2e-15, 0, 0}, {9, 0, 0})});
    EXPECT_FALSE(track.jumps_after(0));
}

}  // namespace
}  // namespace carom::sim
