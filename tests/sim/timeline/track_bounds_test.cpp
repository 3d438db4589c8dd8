// Segments and bounding boxes of tracks.
#include <gtest/gtest.h>

#include "sim/timeline/hermite.h"
#include "sim/timeline/track.h"
#include "timeline_helpers.h"

namespace carom::sim {
namespace {

using test::smooth_key;

void expect_covers(const std::vector<PathSegment>& segments, double from, double to) {
    ASSERT_FALSE(segments.empty());
    EXPECT_EQ(segments.front().start, from);
    EXPECT_EQ(segments.back().end, to);
    for (std::size_t index = 1; index < segments.size(); ++index) {
        EXPECT_EQ(segments[index].start, segments[index - 1].end);
        EXPECT_EQ(segments[index].p0, segments[index - 1].p1);
    }
}

TEST(TrackSegments, RandomIntervals_AreCoveredWithoutGapsAndAgreeWithSample) {
    const Track track = test::random_track(11, 25);
    test::RandomNumbers numbers(11);
    for (int trial = 0; trial < 300; ++trial) {
        const double from = numbers.between(-1, 6);
        const double to = from + numbers.between(0, 2);
        const auto segments = track.segments(from, to);
        expect_covers(segments, from, to);
        for (const PathSegment& segment : segments) {
            for (const double fraction : {0.1, 0.5, 0.77}) {
                const double time = segment.start + fraction * (segment.end - segment.start);
                const MotionState state = track.sample(time);
                EXPECT_LT((hermite_position(segment, time) - state.position).length(), 1e-13);
            }
        }
    }
}

TEST(TrackSegments, CutAtKeys_ReturnsTheirValues) {
    const Track track = test::random_track(12, 6);
    const auto keys = track.keys();
    const auto segments = track.segments(keys[1].time, keys[4].time);
    ASSERT_EQ(segments.size(), 3U);
    for (std::size_t index = 0; index < 3; ++index) {
        EXPECT_EQ(segments[index].p0, keys[index + 1].position);
        EXPECT_EQ(segments[index].v0, keys[index + 1].velocity_out);
        EXPECT_EQ(segments[index].p1, keys[index + 2].position);
        EXPECT_EQ(segments[index].v1, keys[index + 2].velocity_in);
    }
}

TEST(TrackSegments, OneInstant_IsOneSegment) {
    const Track track = test::random_track(13, 4);
    const double first = track.keys().front().time;
    const double last = track.keys().back().time;
    for (const double time :
         {first - 1, first, track.keys()[1].time, first + 0.0007, last, last + 1}) {
        const auto segments = track.segments(time, time);
        ASSERT_EQ(segments.size(), 1U);
        EXPECT_EQ(segments[0].start, time);
        EXPECT_EQ(segments[0].end, time);
        EXPECT_EQ(segments[0].p0, track.sample(time).position);
        EXPECT_EQ(segments[0].p1, track.sample(time).position);
        EXPECT_EQ(segments[0].v0, track.sample(time).velocity);
    }
}

TEST(TrackSegments, OutsideTheKeys_AreConstant) {
    const Track track("ball",
                      {smooth_key(1, {1, 0, 0}, {5, 0, 0}), smooth_key(2, {6, 0, 0}, {5, 0, 0})});
    const auto segments = track.segments(0, 3);
    ASSERT_EQ(segments.size(), 3U);
    EXPECT_EQ(segments[0].p0, segments[0].p1);
    EXPECT_EQ(segments[0].v1, Vec3(0));
    EXPECT_EQ(segments[1].v0, Vec3(5, 0, 0));
    EXPECT_EQ(segments[2].p1, Vec3(6, 0, 0));
    EXPECT_EQ(segments[2].v0, Vec3(0));
}

TEST(TrackBounds, RandomIntervals_ContainEverySample) {
    for (std::uint64_t seed = 20; seed < 30; ++seed) {
        const Track track = test::random_track(seed, 15);
        test::RandomNumbers numbers(seed);
        for (int trial = 0; trial < 50; ++trial) {
            const double from = numbers.between(-0.5, 4);
            const double to = from + numbers.between(0, 1);
            const Bounds bounds = track.position_bounds(from, to);
            for (int sample = 0; sample <= 100; ++sample) {
                const double time = sample == 100 ? to : from + sample * 0.01 * (to - from);
                const Vec3 p = track.sample(time).position;
                for (int axis = 0; axis < 3; ++axis) {
                    ASSERT_LE(bounds.low[axis], p[axis]);
                    ASSERT_GE(bounds.high[axis], p[axis]);
                }
            }
        }
    }
}

TEST(TrackBounds, ThrownBall_IsBoundedByItsApex) {
    // z = 2 t - 5 t^2: apex 0.2 at t = 0.2.
    const Track track(
        "ball", {smooth_key(0, {0, 0, 0}, {1, 0, 2}), smooth_key(0.4, {0.4, 0, 0}, {1, 0, -2})});
    EXPECT_NEAR(track.position_bounds(0, 0.4).high.z, 0.2, 1e-14);
    EXPECT_NEAR(track.position_bounds(0, 0.1).high.z, 0.15, 1e-14);
    EXPECT_NEAR(track.position_bounds(0.3, 0.4).high.z, 0.15, 1e-14);
    EXPECT_NEAR(track.position_bounds(0, 0.4).low.z, 0, 1e-14);
    EXPECT_NEAR(track.position_bounds(0, 0.4).high.x, 0.4, 1e-14);
}

}  // namespace
}  // namespace carom::sim
