#include "pipeline/camera/retime.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/time_map.h"
#include "tests/pipeline/camera/rig_fixture.h"

namespace carom::pipeline {
namespace {

using ::testing::ElementsAre;

CameraRig make_rig(const std::string& name, Rational video_start, Rational video_end,
                   Rational scene_start, Rational scene_end) {
    CameraRig rig = fixture_rig();
    rig.name = name;
    rig.video_start = video_start;
    rig.video_end = video_end;
    rig.time_map = {scene_start, scene_end};
    rig.position = BezierPath{{{{0, -4, 1}, "", 0}, {{1, -4, 1}, "", 0}, {{2, -3, 1}, "", 0}}};
    return rig;
}

/// A film of real time, frozen time, and half a second of reversed time at half speed.
std::vector<CameraRig> film() {
    return {make_rig("first", 0, 2, {3, 10}, {23, 10}), make_rig("freeze", 2, 3, 1, 1),
            make_rig("back", 3, 4, {5, 2}, 2)};
}

RetimeOptions at_speed(Rational speed) {
    RetimeOptions options;
    options.speed = speed;
    return options;
}

void expect_error(const RetimeOptions& options, const std::string& text) {
    try {
        (void)retime_rigs(film(), options);
        FAIL() << "no error: " << text;
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()), text);
    }
}

TEST(Retime, EighthOfTheSpeed_IsExactlyEightTimesSlower) {
    RetimeOptions options = at_speed({1, 8});
    options.from = Rational(12, 10);
    options.to = Rational(2);
    const std::vector<CameraRig> slow = retime_rigs(film(), options);
    ASSERT_EQ(slow.size(), 1u);
    EXPECT_EQ(slow[0].name, "first");
    EXPECT_EQ(slow[0].video_end, Rational(64, 10));
    FilmTiming timing;
    timing.fps = {24000, 1001};
    for (const std::int64_t n : {0, 1, 77, 153}) {
        // Frame n shows t0 + n / (8 fps), the nearest double to that.
        EXPECT_EQ(plan_frame(n, slow, timing, fixture_timeline()).scene_time,
                  (Rational(12, 10) + Rational(n) / (Rational(8) * timing.fps)).to_double());
    }
    // The camera has the same position as before at the same scene time.
    FilmTiming still;
    still.shutter.exposure = 0;
    still.fps = 10;
    const PlannedFrame a = plan_frame(9, film(), still, fixture_timeline());
    const PlannedFrame b = plan_frame(0, slow, still, fixture_timeline());
    EXPECT_EQ(a.scene_time, b.scene_time);
    EXPECT_LT((a.camera_open.position - b.camera_open.position).length(), 1e-15);
    still.fps = 8;
    const PlannedFrame c = plan_frame(13, film(), still, fixture_timeline());
    EXPECT_EQ(c.scene_time, 1.925);
    still.fps = 10;
    const PlannedFrame d = plan_frame(58, slow, still, fixture_timeline());
    EXPECT_EQ(d.scene_time, c.scene_time);
    EXPECT_LT((c.camera_open.position - d.camera_open.position).length(), 1e-15);
}

TEST(Retime, WholeFilm_KeepsTheCutAndTheFrozenTime) {
    const std::vector<CameraRig> slow = retime_rigs(film(), at_speed({1, 4}));
    ASSERT_EQ(slow.size(), 3u);
    EXPECT_EQ(slow[0].video_end, Rational(8));
    EXPECT_EQ(slow[1].video_start, Rational(8));
    EXPECT_EQ(slow[1].video_end, Rational(9));
    EXPECT_EQ(slow[2].video_end, Rational(11));
    EXPECT_EQ(slow[2].time_map.scene_end, Rational(2));
    EXPECT_THAT(find_problems(slow, {}), ElementsAre());
}

TEST(Retime, Reverse_ShowsTheSameFramesBackwards) {
    RetimeOptions options;
    options.reverse = true;
    const std::vector<CameraRig> forward = film();
    const std::vector<CameraRig> backward = retime_rigs(forward, options);
    ASSERT_EQ(backward.size(), 3u);
    EXPECT_EQ(backward[0].name, "back");
    EXPECT_THAT(find_problems(backward, {}), ElementsAre());
    for (std::int64_t n = 1; n < 96; ++n) {
        if (n % 24 == 0 && n != 24) {
            continue;  // the frame at a cut belongs to the rig after it
        }
        const PlannedFrame a = plan_frame(n, forward, {}, fixture_timeline());
        const PlannedFrame b = plan_frame(96 - n, backward, {}, fixture_timeline());
        EXPECT_EQ(a.scene_open, b.scene_open) << n;
        EXPECT_EQ(a.scene_close, b.scene_close) << n;
        if (a.scene_open == a.scene_close) {  // frozen time keeps the order of video time
            EXPECT_EQ(a.camera_open, b.camera_close) << n;
        } else {
            EXPECT_EQ(a.camera_open, b.camera_open) << n;
            EXPECT_EQ(a.camera_close, b.camera_close) << n;
        }
    }
}

TEST(Retime, ReversedRamp_ShowsTheSameTimes) {
    std::vector<CameraRig> forward{make_rig("ramp", 0, 4, 0, 0)};
    forward[0].time_map = {{1, 3}, 0, {{1, 1}, {2, {1, 8}}, {4, {1, 8}}}, true};
    RetimeOptions options;
    options.reverse = true;
    const std::vector<CameraRig> backward = retime_rigs(forward, options);
    for (std::int64_t n = 1; n < 96; ++n) {
        const PlannedFrame a = plan_frame(n, forward, {}, fixture_timeline());
        const PlannedFrame b = plan_frame(96 - n, backward, {}, fixture_timeline());
        EXPECT_EQ(a.scene_time, b.scene_time) << n;
        EXPECT_EQ(a.camera_open, b.camera_open) << n;
        EXPECT_EQ(a.speed, -b.speed) << n;
    }
}

TEST(Retime, IntervalAcrossACut_TakesTheFirstRigThatShowsIt) {
    RetimeOptions options = at_speed(1);
    options.from = Rational(1);
    options.to = Rational(5, 2);
    const std::vector<CameraRig> parts = retime_rigs(film(), options);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].name, "first");
    EXPECT_EQ(parts[0].time_map.scene_end, Rational(23, 10));
    EXPECT_EQ(parts[1].name, "back");  // forwards now, on the same path in reverse
    EXPECT_EQ(parts[1].time_map.scene_start, Rational(23, 10));
    EXPECT_EQ(parts[1].path_start, Rational(2, 5));
    EXPECT_EQ(parts[1].path_end, Rational(0));
    options.rig = "back";
    options.from = Rational(2);
    EXPECT_EQ(retime_rigs(film(), options).at(0).path_start, Rational(1));
    options.reverse = true;
    const CameraRig reversed = retime_rigs(film(), options).at(0);
    EXPECT_EQ(reversed.time_map.scene_start, Rational(5, 2));
    EXPECT_EQ(reversed.path_start, Rational(0));
}

TEST(Retime, PartOfARamp_HasItsPartOfThePath) {
    std::vector<CameraRig> rigs{make_rig("ramp", 0, 4, 0, 0)};
    rigs[0].time_map = {0, 0, {{0, 1}, {4, 0}}, false};  // scene time t - t^2 / 8
    RetimeOptions options = at_speed({1, 10});
    options.from = Rational(7, 8);  // at 1 s of the film
    options.to = Rational(15, 8);   // at 3 s
    const std::vector<CameraRig> part = retime_rigs(rigs, options);
    EXPECT_NEAR(part[0].path_start.to_double(), 0.25, 1e-9);
    EXPECT_NEAR(part[0].path_end.to_double(), 0.75, 1e-9);
    EXPECT_EQ(part[0].video_end, Rational(10));
}

TEST(Retime, Ramp_FilmsFromItsStartToItsLastTime) {
    RetimeOptions options;
    options.from = Rational(1);
    options.ramp = {{0, 1}, {1, {1, 10}}, {3, {1, 10}}, {4, 1}};
    const std::vector<CameraRig> ramp = retime_rigs(film(), options);
    ASSERT_EQ(ramp.size(), 1u);
    EXPECT_EQ(ramp[0].video_end, Rational(4));
    // Scene time advances by 0.55 s + 0.2 s + 0.55 s.
    EXPECT_EQ(scene_time_at(ramp[0], Rational(4)), WideRational(23, 10));
    EXPECT_EQ(ramp[0].path_start, Rational(7, 20));
    EXPECT_EQ(ramp[0].path_end, Rational(1));
    options.reverse = true;
    const std::vector<CameraRig> back = retime_rigs(film(), options);
    EXPECT_EQ(scene_time_at(back[0], Rational(0)), WideRational(23, 10));
    EXPECT_EQ(scene_time_at(back[0], Rational(4)), WideRational(1, 1));
    EXPECT_EQ(speed_at(back[0], Rational(2)), WideRational(-1, 10));
}

TEST(Retime, Fades_KeepTheirFractionOfTheRig) {
    std::vector<CameraRig> rigs{make_rig("a", 0, {5, 2}, 0, {5, 2}), make_rig("b", 2, 4, 2, 3)};
    rigs[1].fade = {1, 2};
    const std::vector<CameraRig> slow = retime_rigs(rigs, at_speed({1, 4}));
    EXPECT_EQ(slow[0].video_end, Rational(10));
    EXPECT_EQ(slow[1].fade, Rational(1));  // b had half speed, so it becomes only twice as long
    EXPECT_EQ(slow[1].video_start, Rational(9));
    EXPECT_THAT(find_problems(slow, {}), ElementsAre());
    RetimeOptions options;
    options.reverse = true;
    const std::vector<CameraRig> back = retime_rigs(rigs, options);
    EXPECT_EQ(back[0].name, "b");
    EXPECT_EQ(back[0].fade, Rational(0));
    EXPECT_EQ(back[1].fade, Rational(1, 2));
    EXPECT_EQ(back[1].video_end, Rational(4));
    EXPECT_THAT(find_problems(back, {}), ElementsAre());
}

TEST(Retime, InvalidOptions_AreReported) {
    RetimeOptions options = at_speed(1);
    options.from = Rational(1);
    options.to = Rational(3);
    expect_error(options,
                 "no camera shows scene time 2.5 s ('first' 0.3 s to 2.3 s, 'freeze' 1 s, 'back' 2 "
                 "s to 2.5 s)");
    options.to = Rational(1, 2);
    expect_error(
        options,
        "the interval of scene time ends at 0.5 s, which is not after its start at 1 s; to "
        "show an interval backwards, use --reverse");
    options = {};
    options.rig = "slow";
    expect_error(options, "there is no camera 'slow'; the cameras are 'first', 'freeze', 'back'");
    expect_error(at_speed(0),
                 "the speed must be above 0; to show the film backwards, use --reverse");
    options = at_speed(1);
    options.ramp = {{0, 1}, {1, 2}};
    expect_error(options, "--ramp already sets the speed; leave out --speed");
    options = {};
    options.ramp = {{1, 1}, {1, 2}};
    expect_error(options, "the times of --ramp must be in increasing order");
}

}  // namespace
}  // namespace carom::pipeline
