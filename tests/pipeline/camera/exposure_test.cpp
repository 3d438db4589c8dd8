#include "pipeline/camera/exposure.h"

#include <gmock/gmock.h>

#include "core/error.h"

namespace carom::pipeline {
namespace {

CameraRig make_rig(Rational video_start, Rational video_end, Rational scene_start,
                   Rational scene_end) {
    CameraRig rig;
    rig.name = "test";
    rig.video_start = video_start;
    rig.video_end = video_end;
    rig.time_map = {scene_start, scene_end};
    return rig;
}

FilmTiming make_timing(Rational fps, Rational exposure) {
    FilmTiming timing;
    timing.fps = fps;
    timing.shutter.exposure = exposure;
    return timing;
}

TEST(Exposure, EighthOfTheSpeed_IsExactInEveryFrame) {
    for (const Rational fps : {Rational(24), Rational(24000, 1001), Rational(60000, 1001)}) {
        const CameraRig rig = make_rig(0, 8, Rational(3, 10), Rational(13, 10));
        const FilmTiming timing = make_timing(fps, Rational(1, 2) / fps);
        for (std::int64_t n = 0; n < 8 * 24; ++n) {
            const Rational expected = Rational(3, 10) + Rational(n) / (Rational(8) * fps);
            EXPECT_EQ(expose(rig, n, timing).scene_time, WideRational(expected)) << n;
            EXPECT_EQ(expose(rig, n, timing).scene_time.to_double(), expected.to_double()) << n;
        }
    }
}

TEST(Exposure, Positions_PlaceTheExposureRelativeToTheFrame) {
    const CameraRig rig = make_rig(0, 1, 0, 1);
    FilmTiming timing = make_timing(24, Rational(1, 48));
    const WideRational frame_time(1, 4);
    timing.shutter.position = ShutterPosition::centre;
    EXPECT_EQ(expose(rig, 6, timing).scene_open, frame_time - WideRational(1, 96));
    EXPECT_EQ(expose(rig, 6, timing).scene_close, frame_time + WideRational(1, 96));
    timing.shutter.position = ShutterPosition::start;
    EXPECT_EQ(expose(rig, 6, timing).scene_open, frame_time);
    EXPECT_EQ(expose(rig, 6, timing).scene_close, frame_time + WideRational(1, 48));
    timing.shutter.position = ShutterPosition::end;
    EXPECT_EQ(expose(rig, 6, timing).scene_open, frame_time - WideRational(1, 48));
    EXPECT_EQ(expose(rig, 6, timing).scene_close, frame_time);
}

TEST(Exposure, VideoClock_ScalesTheBlurWithTheSpeed) {
    const FilmTiming timing = make_timing(24, Rational(1, 48));
    const CameraRig slow = make_rig(2, 10, 1, 2);
    const Exposure exposure = expose(slow, 72, timing);
    EXPECT_EQ(exposure.scene_close - exposure.scene_open, WideRational(1, 8 * 48));
    const Exposure frozen = expose(make_rig(0, 8, 1, 1), 72, timing);
    EXPECT_EQ(frozen.scene_open, frozen.scene_close);
    EXPECT_EQ(frozen.video_close - frozen.video_open, WideRational(1, 48));
}

TEST(Exposure, SceneClock_KeepsTheBlurOfRealTime) {
    FilmTiming timing = make_timing(24, Rational(1, 48));
    timing.shutter.clock = ShutterClock::scene;
    for (const CameraRig& rig : {make_rig(0, 8, 1, 2), make_rig(0, 1, 0, 4)}) {
        const Exposure exposure = expose(rig, 12, timing);
        EXPECT_EQ(exposure.scene_close - exposure.scene_open, WideRational(1, 48));
        EXPECT_EQ(exposure.video_close - exposure.video_open, WideRational(1, 48));
    }
    const Exposure reversed = expose(make_rig(0, 8, 2, 1), 12, timing);
    EXPECT_EQ(reversed.scene_close - reversed.scene_open, WideRational(-1, 48));
    const Exposure frozen = expose(make_rig(0, 8, 1, 1), 12, timing);
    EXPECT_EQ(frozen.scene_open, frozen.scene_close);
}

TEST(Exposure, ReversedTime_ReversesTheShutter) {
    FilmTiming timing = make_timing(24, Rational(1, 48));
    timing.shutter.position = ShutterPosition::start;
    const CameraRig rig = make_rig(0, 1, 3, 2);
    const Exposure exposure = expose(rig, 12, timing);
    EXPECT_EQ(exposure.scene_open, WideRational(5, 2));
    EXPECT_EQ(exposure.scene_close, WideRational(5, 2) - WideRational(1, 48));
}

TEST(Exposure, FirstFrame_OpensBeforeTheRigAlongItsOwnMap) {
    const CameraRig rig = make_rig(2, 3, 5, 7);
    const Exposure exposure = expose(rig, 48, make_timing(24, Rational(1, 24)));
    EXPECT_EQ(exposure.scene_time, WideRational(5, 1));
    EXPECT_EQ(exposure.scene_open, WideRational(5, 1) - WideRational(1, 24));
    const Progress progress = progress_at(rig, exposure.video_open);
    EXPECT_EQ(progress.done, -1.0 / 48);
    EXPECT_EQ(progress.left, 49.0 / 48);
}

TEST(Exposure, ExposureAcrossTheRigsEnds_ContinuesInBothClocksAndDirections) {
    // The exposure of the first frame begins before the rig starts, that of the last ends after it.
    for (const ShutterClock clock : {ShutterClock::video, ShutterClock::scene}) {
        for (const bool reversed : {false, true}) {
            FilmTiming timing = make_timing(24, Rational(1, 24));
            timing.shutter.clock = clock;
            const CameraRig rig = reversed ? make_rig(2, 3, 7, 5) : make_rig(2, 3, 5, 7);
            const WideRational direction(reversed ? -1 : 1, 1);
            // Half an exposure is 1/48 s of film, which the map converts to 2/48 s of scene time.
            const WideRational half =
                direction *
                (clock == ShutterClock::video ? WideRational(1, 24) : WideRational(1, 48));
            const Exposure first = expose(rig, 48, timing);
            EXPECT_EQ(first.scene_open, WideRational(reversed ? 7 : 5, 1) - half);
            EXPECT_EQ(first.scene_close, WideRational(reversed ? 7 : 5, 1) + half);
            const Exposure last = expose(rig, 71, timing);
            EXPECT_EQ(last.scene_time,
                      WideRational(reversed ? 5 : 7, 1) - direction * WideRational(1, 12));
            EXPECT_EQ(last.scene_close, last.scene_time + half);
            EXPECT_EQ(last.video_close, WideRational(3, 1) - WideRational(1, 48));
            timing.shutter.position = ShutterPosition::start;
            timing.shutter.exposure = {1, 12};
            EXPECT_EQ(expose(rig, 71, timing).video_close,
                      WideRational(3, 1) + WideRational(1, 24));
            EXPECT_GT(progress_at(rig, expose(rig, 71, timing).video_close).done, 1);
        }
    }
}

TEST(Exposure, ManyDigits_AreExactOrAnError) {
    const FilmTiming timing = make_timing({24000, 1001}, Rational(1001, 48000));
    const CameraRig rig =
        make_rig(Rational(1, 10'000'019), Rational(33'333'333, 10'000'079),
                 Rational(7'777'777, 10'000'103), Rational(14'142'135, 10'000'121));
    // From one frame to the next, scene time increases by exactly the speed times the frame's
    // duration.
    const WideRational step =
        scene_time_at(rig, WideRational(1, 24)) - scene_time_at(rig, WideRational(0, 1));
    EXPECT_NEAR(step.to_double(),
                (14142135 / 10000121.0 - 7777777 / 10000103.0) / 24 /
                    (33333333 / 10000079.0 - 1 / 10000019.0),
                1e-15);
    const std::int64_t huge = 9'000'000'000'000'000'001;
    const CameraRig absurd = make_rig(Rational(1, huge), Rational(huge - 2, huge - 3),
                                      Rational(1, huge - 4), Rational(1, huge - 6));
    EXPECT_THROW((void)expose(absurd, 7, timing), Error);
}

}  // namespace
}  // namespace carom::pipeline
