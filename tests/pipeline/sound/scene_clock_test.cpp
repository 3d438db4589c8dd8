#include "pipeline/sound/scene_clock.h"

#include <gmock/gmock.h>

#include "pipeline/camera/time_map.h"
#include "tests/pipeline/camera/rig_fixture.h"

namespace carom::pipeline {
namespace {

/// From 1 s to 7 s, with a turn between 5 s and 6 s and a still picture from 6.5 s on.
CameraRig ramp(bool is_smooth) {
    CameraRig rig = fixture_rig();
    rig.video_start = 1;
    rig.video_end = 7;
    rig.time_map.scene_start = {3, 10};
    rig.time_map.is_smooth = is_smooth;
    rig.time_map.speeds = {{2, 1}, {3, {1, 8}}, {5, {1, 8}}, {6, {-1, 2}}, {{13, 2}, 0}};
    return rig;
}

void expect_the_exact_map(const CameraRig& rig) {
    for (const SceneClock& clock : scene_clocks(rig)) {
        for (int i = 0; i <= 64; ++i) {
            const Rational part(i, 64);
            const double time = clock.from().video_time * (1 - part.to_double()) +
                                clock.to().video_time * part.to_double();
            const WideRational exact(Rational::nearest(time));
            EXPECT_NEAR(clock.scene_time(time), scene_time_at(rig, exact).to_double(), 1e-11)
                << time;
            EXPECT_NEAR(clock.speed(time), speed_at(rig, exact).to_double(), 1e-11) << time;
        }
    }
}

TEST(SceneClock, TimesAndSpeeds_AreThoseOfTheExactMap) {
    CameraRig linear = fixture_rig();
    linear.video_start = {3, 7};
    linear.video_end = 3;
    linear.time_map = {{5, 3}, {1, 3}};
    expect_the_exact_map(linear);
    expect_the_exact_map(ramp(false));
    expect_the_exact_map(ramp(true));
}

TEST(SceneClock, Stretches_FollowEachOtherAndDoNotTurn) {
    for (const bool is_smooth : {false, true}) {
        const std::vector<SceneClock> clocks = scene_clocks(ramp(is_smooth));
        ASSERT_EQ(clocks.size(), 7U);  // the change from 1/8 to -1/2 is two stretches
        EXPECT_EQ(clocks.front().from().video_time, 1);
        EXPECT_EQ(clocks.back().to().video_time, 7);
        for (std::size_t i = 0; i < clocks.size(); ++i) {
            if (i > 0) {
                EXPECT_EQ(clocks[i].from().video_time, clocks[i - 1].to().video_time);
                EXPECT_EQ(clocks[i].from().scene_time, clocks[i - 1].to().scene_time);
            }
            const double middle = 0.5 * (clocks[i].from().video_time + clocks[i].to().video_time);
            const double sign = clocks[i].speed(middle);
            for (const SceneClock::End& end : {clocks[i].from(), clocks[i].to()}) {
                EXPECT_GE(clocks[i].speed(end.video_time) * sign, -1e-15) << i;
            }
        }
        // The turn: where the speed is 0, at the fifth of the change that is above it.
        EXPECT_NEAR(clocks[3].speed(clocks[3].to().video_time), 0, 1e-15);
        EXPECT_EQ(clocks.back().speed(6.75), 0);
    }
    EXPECT_NEAR(scene_clocks(ramp(false))[3].to().video_time, 5.2, 1e-14);
}

TEST(SceneClock, KeysOutsideOfTheRig_AreCutOff) {
    CameraRig rig = ramp(false);
    rig.video_start = {5, 2};
    rig.video_end = 4;
    const std::vector<SceneClock> clocks = scene_clocks(rig);
    ASSERT_EQ(clocks.size(), 2U);
    EXPECT_EQ(clocks[0].from().video_time, 2.5);
    EXPECT_EQ(clocks[0].to().video_time, 3);
    EXPECT_EQ(clocks[1].to().video_time, 4);
    expect_the_exact_map(rig);
}

}  // namespace
}  // namespace carom::pipeline
