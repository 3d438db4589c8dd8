#include "pipeline/camera/frame_plan.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/camera/camera_path.h"
#include "pipeline/camera/rig_state.h"

namespace carom::pipeline {
namespace {

sim::Key make_key(double time, const Vec3& position, const Vec3& in, const Vec3& out) {
    sim::Key key;
    key.time = time;
    key.position = position;
    key.velocity_in = in;
    key.velocity_out = out;
    return key;
}

/// "cue" rolls along x at 2 m/s from the origin until it stops at 1 s; "one" rests at (3,1,0).
sim::Timeline make_timeline() {
    sim::Timeline timeline;
    timeline.end_time = 4;
    timeline.tracks.emplace_back("cue", std::vector{make_key(0, {0, 0, 0}, {2, 0, 0}, {2, 0, 0}),
                                                    make_key(1, {2, 0, 0}, {2, 0, 0}, {0, 0, 0}),
                                                    make_key(4, {2, 0, 0}, {0, 0, 0}, {0, 0, 0})});
    timeline.tracks.emplace_back("one", std::vector{make_key(0, {3, 1, 0}, {0, 0, 0}, {0, 0, 0})});
    return timeline;
}

CameraRig make_rig(Rational scene_start, Rational scene_end) {
    CameraRig rig;
    rig.name = "a";
    rig.video_start = 0;
    rig.video_end = 2;
    rig.time_map = {scene_start, scene_end};
    rig.position = BezierPath{{{{0, -4, 1}, "", 0}}, false};
    rig.target = BezierPath{{{{0, 0, 0}, "", 0}}, false};
    rig.focus = {Focus{5.0, ""}, Focus{5.0, ""}, Easing::linear};
    return rig;
}

void expect_error(const CameraRig& rig, std::int64_t frame, const std::string& text) {
    try {
        (void)plan_frame(frame, std::vector{rig}, {}, make_timeline());
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()), text);
    }
}

TEST(FramePlan, NormalSpeed_FillsTimesAndCamera) {
    const PlannedFrame frame = plan_frame(12, std::vector{make_rig(1, 3)}, {}, make_timeline());
    EXPECT_EQ(frame.number, 12);
    EXPECT_EQ(frame.rig, "a");
    EXPECT_EQ(frame.video_time, 0.5);
    EXPECT_EQ(frame.scene_time, 1.5);
    EXPECT_EQ(frame.scene_open, Rational(143, 96).to_double());
    EXPECT_EQ(frame.scene_close, Rational(145, 96).to_double());
    EXPECT_FALSE(frame.reversed);
    EXPECT_EQ(frame.camera_open, frame.camera_close);
    EXPECT_EQ(frame.camera_open.position, Vec3(0, -4, 1));
    EXPECT_EQ(frame.camera_open.focus_distance, 5);
}

/// A rig in which every value changes.
CameraRig make_moving_rig() {
    CameraRig rig = make_rig({1, 3}, {7, 5});
    rig.position =
        BezierPath{{{{-1, -4, 1.1}, "", 0}, {{0.3, -1, 2}, "cue", 0.7}, {{2, -2, 1}, "", 0}}, true};
    rig.target = FollowPath{"cue", {0, 0, 0.1}, 0.15};
    rig.fov = {0.7, 0.5, Easing::smooth};
    rig.focus = {Focus{{}, "cue"}, Focus{{}, "one"}, Easing::smooth};
    rig.aperture = {Aperture{2.8, true}, Aperture{0.004, false}, Easing::linear};
    rig.roll = {0.1, -0.05, Easing::linear};
    return rig;
}

CameraRig reversed(CameraRig rig) {
    std::swap(rig.time_map.scene_start, rig.time_map.scene_end);
    auto& position = std::get<BezierPath>(rig.position);
    std::reverse(position.points.begin(), position.points.end());
    std::swap(rig.fov.start, rig.fov.end);
    std::swap(rig.focus.start, rig.focus.end);
    std::swap(rig.aperture.start, rig.aperture.end);
    std::swap(rig.roll.start, rig.roll.end);
    return rig;
}

TEST(FramePlan, ReversedRig_HasTheSameExposuresBitForBit) {
    const sim::Timeline timeline = make_timeline();
    for (const Rational fps : {Rational(24), Rational(25), Rational(30000, 1001)}) {
        CameraRig rig = make_moving_rig();
        rig.video_end = Rational(48) / fps;
        FilmTiming timing;
        timing.fps = fps;
        timing.shutter.exposure = Rational(1, 2) / fps;
        const std::vector forward{rig}, backward{reversed(rig)};
        for (std::int64_t n = 1; n < 48; ++n) {
            const PlannedFrame a = plan_frame(n, forward, timing, timeline);
            const PlannedFrame b = plan_frame(48 - n, backward, timing, timeline);
            EXPECT_FALSE(a.reversed);
            EXPECT_TRUE(b.reversed);
            EXPECT_EQ(a.scene_open, b.scene_open) << n;
            EXPECT_EQ(a.scene_close, b.scene_close) << n;
            EXPECT_EQ(a.camera_open, b.camera_open) << n;
            EXPECT_EQ(a.camera_close, b.camera_close) << n;
        }
    }
}

TEST(FramePlan, ReversedTime_ExchangesCamerasAndSceneTimes) {
    CameraRig rig = make_rig(2, 0);
    rig.position = BezierPath{{{{0, -4, 1}, "", 0}, {{2, -4, 1}, "", 0}}, false};
    const PlannedFrame frame = plan_frame(24, std::vector{rig}, {}, make_timeline());
    EXPECT_TRUE(frame.reversed);
    EXPECT_LT(frame.scene_open, frame.scene_close);
    // The shutter opens at 1 s - 1/96 s of video time, which is the later scene time.
    EXPECT_EQ(frame.camera_close.position.x, Rational(95, 96).to_double());
    EXPECT_EQ(frame.camera_open.position.x, Rational(97, 96).to_double());
}

TEST(FramePlan, FrozenTime_KeepsTheCameraMoving) {
    CameraRig rig = make_rig({1, 2}, {1, 2});
    rig.position = BezierPath{{{{0, -4, 1}, "", 0}, {{2, -4, 1}, "", 0}}, false};
    for (const ShutterClock clock : {ShutterClock::video, ShutterClock::scene}) {
        FilmTiming timing;
        timing.shutter.clock = clock;
        const PlannedFrame frame = plan_frame(24, std::vector{rig}, timing, make_timeline());
        EXPECT_EQ(frame.scene_open, 0.5);
        EXPECT_EQ(frame.scene_close, 0.5);
        EXPECT_FALSE(frame.reversed);
        EXPECT_LT(frame.camera_open.position.x, frame.camera_close.position.x);
    }
}

TEST(FramePlan, Cut_BelongsToTheRigThatStartsThere) {
    CameraRig first = make_rig(0, 2), second = make_rig(3, 1);
    second.name = "b";
    second.video_start = 2;
    second.video_end = 4;
    const std::vector rigs{first, second};
    EXPECT_EQ(plan_frame(47, rigs, {}, make_timeline()).rig, "a");
    EXPECT_EQ(plan_frame(48, rigs, {}, make_timeline()).rig, "b");
    EXPECT_EQ(plan_frame(48, rigs, {}, make_timeline()).scene_time, 3);
    EXPECT_EQ(plan_frame(95, rigs, {}, make_timeline()).scene_time, Rational(25, 24).to_double());
    EXPECT_THROW((void)plan_frame(96, rigs, {}, make_timeline()), Error);
    EXPECT_THROW((void)plan_frame(-1, rigs, {}, make_timeline()), Error);
}

TEST(FramePlan, ControlPointAtAnObject_IsItsPositionAtThatTime) {
    CameraRig rig = make_rig(0, 2);
    rig.position = BezierPath{{{{0, -1, 0.5}, "cue", 0.25}}, false};
    EXPECT_EQ(plan_frame(30, std::vector{rig}, {}, make_timeline()).camera_open.position,
              Vec3(0.5, -1, 0.5));
}

TEST(FramePlan, FollowedObject_IsAtItsPositionOfThatInstant) {
    CameraRig rig = make_rig(0, 2);
    rig.target = FollowPath{"cue", {0, 0, 0.25}, 0};
    FilmTiming timing;
    timing.shutter.position = ShutterPosition::start;
    const PlannedFrame frame = plan_frame(12, std::vector{rig}, timing, make_timeline());
    EXPECT_EQ(frame.camera_open.target, Vec3(1, 0, 0.25));
    EXPECT_DOUBLE_EQ(frame.camera_close.target.x, 1 + 2.0 / 48);
}

TEST(MeanPosition, AcrossTheStop_IsTheIntegralOverTheWindow) {
    const sim::Timeline timeline = make_timeline();
    const sim::Track& cue = *timeline.find("cue");
    // Over [0.8, 1.2]: the mean of 2 t up to 1 s and of 2 after it, (0.36 + 0.4) / 0.4.
    EXPECT_NEAR(mean_position(cue, 1, 0.4).x, 1.9, 1e-14);
    EXPECT_NEAR(mean_position(cue, 0.5, 0.4).x, 1.0, 1e-14);
    // Outside the bake the poses of its ends apply: over [-0.2, 0.2] the mean is (0 + 0.04) / 0.4.
    EXPECT_NEAR(mean_position(cue, 0, 0.4).x, 0.1, 1e-14);
    EXPECT_EQ(mean_position(cue, 2.3, 0.4), Vec3(2, 0, 0));
    EXPECT_EQ(mean_position(cue, 0.3, 0), cue.sample(0.3).position);
}

TEST(MeanPosition, CurvedPath_AgreesWithNumericalIntegration) {
    const sim::Track track("ball", {make_key(0, {0, 0, 0}, {1, 0, 0}, {1, -2, 0.5}),
                                    make_key(1, {1, 1, 0}, {-3, 4, 0}, {0, 1, 0}),
                                    make_key(1.5, {2, 1, 1}, {0, 0, 2}, {0, 0, 0})});
    const int steps = 20000;
    Vec3 sum(0, 0, 0);
    for (int i = 0; i < steps; ++i) {
        sum += track.sample(0.3 + (i + 0.5) * 1.1 / steps).position;
    }
    EXPECT_LT((mean_position(track, 0.85, 1.1) - sum / steps).length(), 1e-8);
}

TEST(RigState, FocusOnAnObject_IsItsDepthAlongTheAxis) {
    CameraRig rig = make_rig(0, 2);
    rig.position = BezierPath{{{{0, 0, 0}, "", 0}}, false};
    rig.target = BezierPath{{{{10, 0, 0}, "", 0}}, false};
    rig.focus = {Focus{{}, "one"}, Focus{{}, "one"}, Easing::linear};
    const render::CameraState state = camera_state(rig, {}, make_timeline());
    EXPECT_EQ(state.focus_distance, 3);  // "one" is at (3, 1, 0)
    rig.focus = {Focus{}, Focus{}, Easing::linear};
    EXPECT_EQ(camera_state(rig, {}, make_timeline()).focus_distance, 10);
}

TEST(RigState, RackFocus_ChangesFromOneObjectToTheOther) {
    CameraRig rig = make_rig(0, 2);
    rig.position = BezierPath{{{{-1, 0, 0}, "", 0}}, false};
    rig.target = BezierPath{{{{10, 0, 0}, "", 0}}, false};
    rig.focus = {Focus{{}, "cue"}, Focus{{}, "one"}, Easing::smooth};
    const sim::Timeline timeline = make_timeline();
    EXPECT_EQ(camera_state(rig, {{0, 1}, 0}, timeline).focus_distance, 1);
    EXPECT_EQ(camera_state(rig, {{1, 0}, 2}, timeline).focus_distance, 4);
    EXPECT_DOUBLE_EQ(camera_state(rig, {{0.25, 0.75}, 0}, timeline).focus_distance,
                     1 + 3 * 0.15625);
}

TEST(RigState, FNumber_DeterminesTheLensRadius) {
    // 90 degrees on a sensor 24 mm high: 12 mm focal length; at f/2 the opening is 6 mm wide.
    EXPECT_NEAR(lens_radius({2, true}, std::acos(0.0)), 0.003, 1e-15);
    EXPECT_EQ(lens_radius({0.008, false}, 0.7), 0.008);
    CameraRig rig = make_rig(0, 2);
    rig.fov = {std::acos(0.0), std::acos(0.0), Easing::linear};
    rig.aperture = {Aperture{2, true}, Aperture{4, true}, Easing::linear};
    EXPECT_NEAR(camera_state(rig, {{0.5, 0.5}, 0}, make_timeline()).lens_radius, 0.002, 1e-15);
    rig.aperture = {Aperture{0.002, false}, Aperture{0, false}, Easing::linear};
    EXPECT_EQ(camera_state(rig, {{1.01, -0.01}, 0}, make_timeline()).lens_radius, 0);
}

TEST(RigState, FocusBehindTheCamera_IsAtTheShortestDistance) {
    CameraRig rig = make_rig(0, 2);
    rig.focus.start = rig.focus.end = Focus{{}, "cue"};
    EXPECT_TRUE(find_focus_behind_camera(rig, {{0, 1}, 0}, make_timeline()).empty());
    rig.target = BezierPath{{{{0, -9, 1}, "", 0}}, false};
    EXPECT_EQ(camera_state(rig, {{0, 1}, 0}, make_timeline()).focus_distance, kNearestFocus);
    EXPECT_EQ(find_focus_behind_camera(rig, {{0, 1}, 0}, make_timeline()),
              std::vector<std::string>{"cue"});
    rig.focus.start = Focus{2.5, ""};
    EXPECT_TRUE(find_focus_behind_camera(rig, {{0, 1}, 0}, make_timeline()).empty());
    EXPECT_FALSE(find_focus_behind_camera(rig, {{0.5, 0.5}, 0}, make_timeline()).empty());
}

TEST(FramePlan, CameraWithoutAValidView_IsAnErrorWithItsName) {
    CameraRig rig = make_rig(0, 2);
    rig.target = rig.position;
    expect_error(rig, 3,
                 "camera 'a', frame 3: the camera's position and target are the same point");
    rig = make_rig(0, 2);
    rig.up = {{0, -4, 1}, {0, -4, 1}};
    expect_error(
        rig, 3,
        "camera 'a', frame 3: the camera looks straight along its up direction; give another 'up'");
    rig = make_rig(0, 2);
    rig.target = FollowPath{"queue", {0, 0, 0}, 0};
    expect_error(rig, 0, "camera 'a', frame 0: object 'queue' is not in the timeline");
    rig = make_rig(0, 2);
    rig.aperture = {Aperture{0, true}, Aperture{0, true}, Easing::linear};
    expect_error(rig, 0, "camera 'a', frame 0: the f-number is not above 0");
    rig = make_rig(0, 2);
    rig.fov = {4, 4, Easing::linear};
    expect_error(rig, 0, "camera 'a', frame 0: the field of view is not between 0 and 180 degrees");
}

}  // namespace
}  // namespace carom::pipeline
