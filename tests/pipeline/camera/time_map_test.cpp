// Tests of speed ramps; linear maps are in exposure_test.cpp.
#include "pipeline/camera/time_map.h"

#include <gmock/gmock.h>

#include "pipeline/camera/exposure.h"
#include "pipeline/camera/frame_plan.h"
#include "tests/pipeline/camera/rig_fixture.h"

namespace carom::pipeline {
namespace {

/// Films from 1 s to 6 s, starting at scene time 3/10 s. The speed is 1 until 2 s, decreases to 1/8
/// at 3 s, is constant until 5 s, and changes to -1/2 at 6 s.
CameraRig ramp(bool is_smooth) {
    CameraRig rig = fixture_rig();
    rig.video_start = 1;
    rig.video_end = 6;
    rig.time_map.scene_start = {3, 10};
    rig.time_map.is_smooth = is_smooth;
    rig.time_map.speeds = {{2, 1}, {3, {1, 8}}, {5, {1, 8}}, {6, {-1, 2}}};
    return rig;
}

WideRational scene(const CameraRig& rig, Rational time) {
    return scene_time_at(rig, time);
}

TEST(SpeedRamp, SceneTime_IsTheExactIntegralOfTheSpeed) {
    for (const bool is_smooth : {false, true}) {
        const CameraRig rig = ramp(is_smooth);
        EXPECT_EQ(scene(rig, 1), WideRational(3, 10));
        EXPECT_EQ(scene(rig, 2), WideRational(13, 10));
        // During a change over one second, scene time advances by the mean speed, linear or smooth.
        EXPECT_EQ(scene(rig, 3), WideRational(13, 10) + WideRational(9, 16));
        EXPECT_EQ(scene(rig, 5), WideRational(13, 10) + WideRational(13, 16));
        EXPECT_EQ(scene(rig, 6), WideRational(13, 10) + WideRational(10, 16));
        EXPECT_EQ(scene(rig, 7), WideRational(13, 10) + WideRational(2, 16));
        EXPECT_EQ(scene(rig, 0),
                  WideRational(-7, 10));  // the first speed also applies before the rig
    }
    // After half of the first change: 1/2 s at speed 1, minus 7/8 of the integrated fraction.
    EXPECT_EQ(scene(ramp(false), {5, 2}),
              WideRational(13, 10) + WideRational(1, 2) - WideRational(7, 8) * WideRational(1, 8));
    EXPECT_EQ(scene(ramp(true), {5, 2}),
              WideRational(13, 10) + WideRational(1, 2) - WideRational(7, 8) * WideRational(3, 32));
}

TEST(SpeedRamp, Speed_IsTheSlopeOfTheSceneTime) {
    for (const bool is_smooth : {false, true}) {
        const CameraRig rig = ramp(is_smooth);
        EXPECT_EQ(speed_at(rig, Rational(1)), WideRational(1, 1));
        EXPECT_EQ(speed_at(rig, Rational(4)), WideRational(1, 8));
        EXPECT_EQ(speed_at(rig, Rational(9)), WideRational(-1, 2));
        EXPECT_EQ(speed_at(rig, Rational(5, 2)), WideRational(9, 16));
        for (Rational time(9, 8); time < Rational(6); time = time + Rational(1, 7)) {
            const Rational h(1, 10000);
            const double slope =
                (scene(rig, time + h).to_double() - scene(rig, time - h).to_double()) / 2e-4;
            EXPECT_NEAR(speed_at(rig, time).to_double(), slope, 1e-4) << time.to_double();
        }
    }
}

TEST(SpeedRamp, AtFilmRates_StaysExact) {
    // At 24000/1001 frames per second every exposed interval is exact: nothing is rounded.
    for (const bool is_smooth : {false, true}) {
        CameraRig rig = ramp(is_smooth);
        FilmTiming timing;
        timing.fps = {24000, 1001};
        timing.shutter.exposure = {1001, 48000};
        for (std::int64_t n = 24; n < 143; ++n) {
            const Exposure exposure = expose(rig, n, timing);
            // A map with another start gives an interval of the same duration.
            CameraRig shifted = rig;
            shifted.time_map.scene_start = 0;
            EXPECT_EQ(
                exposure.scene_close - exposure.scene_open,
                expose(shifted, n, timing).scene_close - expose(shifted, n, timing).scene_open)
                << n;
        }
    }
}

TEST(SpeedRamp, Reversed_ShowsTheSameTimes) {
    for (const bool is_smooth : {false, true}) {
        const CameraRig rig = ramp(is_smooth);
        CameraRig back = rig;  // mirrored about 7/2 s of the film
        back.time_map.scene_start = scene(rig, 6).narrow();
        back.time_map.speeds = {{1, {1, 2}}, {2, {-1, 8}}, {4, {-1, 8}}, {5, -1}};
        for (Rational time(1); time < Rational(6); time = time + Rational(5, 24)) {
            EXPECT_EQ(scene(rig, time), scene(back, Rational(7) - time)) << time.to_double();
        }
    }
}

TEST(SpeedRamp, SceneClock_FollowsTheSignOfTheSpeed) {
    CameraRig rig = ramp(false);
    rig.time_map.speeds = {{2, 1}, {4, -1}};
    FilmTiming timing;
    timing.shutter.clock = ShutterClock::scene;
    const auto blur = [&](std::int64_t n) {
        const Exposure exposure = expose(rig, n, timing);
        return exposure.scene_close - exposure.scene_open;
    };
    EXPECT_EQ(blur(24), WideRational(1, 48));
    EXPECT_EQ(blur(71), WideRational(1, 48));
    EXPECT_EQ(blur(72), WideRational(0, 1));  // 3 s: speed 0 where time reverses
    EXPECT_EQ(blur(73), WideRational(-1, 48));
}

TEST(SpeedRamp, TooManyDigits_AreRounded) {
    CameraRig rig = ramp(true);
    rig.time_map.speeds = {{{7'777'777, 10'000'103}, {14'142'135, 10'000'121}},
                           {{33'333'333, 10'000'079}, {1, 10'000'019}}};
    const Rational time(16'777'213, 10'000'189);
    const double exact = scene(rig, time).to_double();
    const double h = 1e-3;
    const double before = scene(rig, time - Rational(1, 1000)).to_double();
    const double after = scene(rig, time + Rational(1, 1000)).to_double();
    EXPECT_NEAR((after - before) / (2 * h), speed_at(rig, time).to_double(), 1e-5);
    EXPECT_NEAR((after + before) / 2, exact, 1e-6);
}

TEST(SpeedRamp, ShownSceneTimes_IncludeTheExtremesAtItsKeys) {
    CameraRig rig = ramp(false);
    rig.time_map.speeds = {{1, 1}, {2, 1}, {3, -1}, {6, -1}};
    EXPECT_EQ(shown_scene_times(rig).last, Rational(13, 10));
    EXPECT_EQ(shown_scene_times(rig).first, Rational(-17, 10));
    rig.time_map = {2, 1};
    EXPECT_EQ(shown_scene_times(rig).first, Rational(1));
    EXPECT_EQ(shown_scene_times(rig).last, Rational(2));
}

TEST(SpeedRamp, PlannedFrame_HasItsSpeed) {
    CameraRig rig = ramp(false);
    rig.video_start = 0;
    const PlannedFrame slow = plan_frame(96, std::vector{rig}, {}, fixture_timeline());
    EXPECT_EQ(slow.speed, 0.125);
    EXPECT_FALSE(slow.reversed);
    rig.time_map = {2, 1};
    const PlannedFrame back = plan_frame(96, std::vector{rig}, {}, fixture_timeline());
    EXPECT_DOUBLE_EQ(back.speed, -1.0 / 6);
    EXPECT_TRUE(back.reversed);
}

TEST(PathInterval, PartOfAPath_HasTheSameCameras) {
    CameraRig whole = fixture_rig();
    whole.position = BezierPath{
        {{{0, -4, 1}, "", 0}, {{2, -4, 1}, "", 0}, {{2, -2, 1}, "", 0}}, true, Easing::smooth};
    CameraRig part = whole;  // its second half, backwards, at half the speed
    part.path_start = 1;
    part.path_end = {1, 2};
    part.time_map = {2, 1};
    FilmTiming still;
    still.shutter.exposure = 0;
    for (std::int64_t n = 1; n < 24; ++n) {
        const PlannedFrame a = plan_frame(24 + n, std::vector{whole}, still, fixture_timeline());
        const PlannedFrame b = plan_frame(48 - 2 * n, std::vector{part}, still, fixture_timeline());
        EXPECT_EQ(a.scene_time, b.scene_time) << n;
        EXPECT_EQ(a.camera_open, b.camera_open) << n;
    }
}

}  // namespace
}  // namespace carom::pipeline
