// Cameras that pass over or under their targets, exactly or nearly.
#include "pipeline/camera/steady_up.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"
#include "pipeline/camera/exposure.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/path_fit.h"
#include "pipeline/camera/retime.h"
#include "pipeline/camera/rig_state.h"
#include "pipeline/camera/view_axes.h"
#include "tests/pipeline/camera/rig_fixture.h"

namespace carom::pipeline {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180;

CameraPath fixed(const Vec3& point) {
    return BezierPath{{{point, "", 0}}};
}

CameraPath line(const Vec3& from, const Vec3& to) {
    return BezierPath{{{from, "", 0}, {to, "", 0}}};
}

/// Two seconds from `from` to `to`, looking at the origin.
CameraRig flight(const Vec3& from, const Vec3& to) {
    CameraRig rig = fixture_rig();
    rig.position = line(from, to);
    rig.target = fixed({0, 0, 0});
    return rig;
}

/// At 1 m/s straight over the origin, or `beside` it, after one second.
CameraRig flight_over(double beside, double height = 0.9) {
    return flight({-1, beside, height}, {1, beside, height});
}

double turn_between(const ViewAxes& a, const ViewAxes& b) {
    const double trace = a.right.dot(b.right) + a.up.dot(b.up) + a.ahead.dot(b.ahead);
    return std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0));
}

struct Turns {
    double between = 0;  // frames, the largest, degrees
    double in_shutter = 0;
};

/// How far the camera turns from frame to frame and during exposures. Also checks that the up
/// direction that the renderer mixes stays upright at both ends.
Turns turns_of(const CameraRig& given, const FilmTiming& timing = {},
               const sim::Timeline& timeline = fixture_timeline()) {
    const std::vector<CameraRig> rigs = with_fitted_paths(std::span(&given, 1), timeline);
    Turns turns;
    std::optional<ViewAxes> before;
    const std::int64_t first = given.video_start.to_double() > 0 ? 1 : 0;
    for (std::int64_t n = first; n < frame_count(rigs, timing); ++n) {
        const PlannedFrame frame = plan_frame(n, rigs, timing, timeline);
        const ViewAxes open = view_axes(frame.camera_open);
        const ViewAxes close = view_axes(frame.camera_close);
        turns.in_shutter = std::max(turns.in_shutter, turn_between(open, close) / kDegree);
        const ViewAxes& now = frame.reversed ? close : open;
        if (before) {
            turns.between = std::max(turns.between, turn_between(*before, now) / kDegree);
        }
        before = now;
    }
    return turns;
}

/// The rig's camera with an upper edge that follows `up` everywhere, as it was before.
render::CameraState plain_state(CameraRig rig, const Rational& time) {
    rig.up_turns.reset();
    return camera_state(rig, {progress_at(rig, time), scene_time_at(rig, time).to_double()},
                        fixture_timeline());
}

render::CameraState steady_state(CameraRig rig, const Rational& time) {
    keep_up(std::span(&rig, 1), fixture_timeline());
    return camera_state(rig, {progress_at(rig, time), scene_time_at(rig, time).to_double()},
                        fixture_timeline());
}

// At 1 m/s and a height of 0.9 m the view itself turns by at most 2.7 degrees in 1/24 s.
TEST(SteadyUp, PathOverTheTarget_KeepsThePictureTheSameWayUp) {
    for (const double beside :
         {0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-3, -1e-3, 5e-3, 1e-2, 1.5e-2, 2e-2, 2.5e-2}) {
        const Turns turns = turns_of(flight_over(beside));
        EXPECT_LT(turns.between, 15) << beside;
        EXPECT_LT(turns.in_shutter, 10) << beside;
        const Turns under = turns_of(flight_over(beside, -0.9));
        EXPECT_LT(under.between, 15) << beside;
    }
}

TEST(SteadyUp, FramesBeforeThePassage_KeepTheirBits) {
    const CameraRig rig = flight_over(0);
    for (int i = 0; i <= 11; ++i) {
        EXPECT_EQ(steady_state(rig, {i, 12}), plain_state(rig, {i, 12})) << i;
    }
    const render::CameraState after = steady_state(rig, {13, 12});
    const Vec3 ahead = (after.target - after.position).normalized();
    EXPECT_LT((after.up + upright_of(ahead, {0, 0, 1})).length(), 1e-9);
}

TEST(SteadyUp, CamerasThatPassAtADistance_KeepTheirBits) {
    const auto expect_plain = [](const CameraRig& rig) {
        for (int i = 0; i <= 48; ++i) {
            EXPECT_EQ(steady_state(rig, {i, 24}), plain_state(rig, {i, 24})) << i;
        }
    };
    expect_plain(flight_over(0.1));
    expect_plain(fixture_rig());
    CameraRig chase = fixture_rig();
    chase.target = FollowPath{"cue", {0, 0, 0}, 0, 0};
    expect_plain(chase);
    // Round a point beside the vertical: the picture turns once in two seconds, as it should.
    CameraRig round = fixture_rig();
    round.position = OrbitPath{ControlPoint{{0, 0, 1}, "", 0}, {0.02, 0.02}, 0, 2 * kPi, {}};
    expect_plain(round);
}

TEST(SteadyUp, ChangesOfUp_AreAsTheyAreWritten) {
    CameraRig rig = flight({-1, 0, 1}, {-1, 0.1, 1});
    rig.up = {{0, 0, 1}, {0, 1, 0}};
    for (int i = 0; i <= 48; ++i) {
        EXPECT_EQ(steady_state(rig, {i, 24}), plain_state(rig, {i, 24})) << i;
    }
    // The user turns the picture over in 1/24 s.
    rig.up = {{0, 0, 1}, {0, 0.001, -1}};
    rig.up.keys = {{{1, 1}, {0, 0, 1}}, {{25, 24}, {0, 0.001, -1}}};
    EXPECT_EQ(steady_state(rig, {3, 2}), plain_state(rig, {3, 2}));
}

TEST(SteadyUp, OrbitOverTheTop_TurnsOverTwiceInARound) {
    CameraRig rig = fixture_rig();
    Quat upright;
    upright.setAxisAngle({1, 0, 0}, kPi / 2);
    rig.position = OrbitPath{ControlPoint{{0, 0, 0}, "", 0}, {2, 1}, 0, 2 * kPi, upright};
    EXPECT_LT(turns_of(rig).between, 25);
    keep_up(std::span(&rig, 1), fixture_timeline());
    ASSERT_EQ(rig.up_turns->size(), 2U);
    EXPECT_TRUE(rig.up_turns->front().is_over);
    EXPECT_FALSE(rig.up_turns->back().is_over);
    EXPECT_EQ(steady_state(rig, {19, 10}), plain_state(rig, {19, 10}));
}

TEST(SteadyUp, ViewAlongUpForAWhile_IsCarriedFromWhereItEnds) {
    // The camera stands over the ball, which rolls away after a second; and the other way round.
    sim::Timeline timeline;
    timeline.end_time = 2;
    timeline.tracks.emplace_back("cue",
                                 std::vector{fixture_key(0, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}),
                                             fixture_key(1, {0, 0, 0}, {0, 0, 0}, {0, 1, 0}),
                                             fixture_key(2, {0, 1, 0}, {0, 1, 0}, {0, 0, 0})});
    CameraRig rig = fixture_rig();
    rig.position = fixed({0, 0, 1});
    rig.target = FollowPath{"cue", {0, 0, 0}, 0, 0};
    EXPECT_LT(turns_of(rig, {}, timeline).between, 5);
    std::swap(rig.time_map.scene_start, rig.time_map.scene_end);
    EXPECT_LT(turns_of(rig, {}, timeline).between, 5);
    // With the whole shot along `up` nothing says what is up.
    rig.target = fixed({0, 0, 0});
    EXPECT_THROW((void)turns_of(rig, {}, timeline), Error);
    rig.up = {{0, 1, 0}, {0, 1, 0}};
    EXPECT_EQ(turns_of(rig, {}, timeline).between, 0);
}

TEST(SteadyUp, TargetThatPassesBeneath_IsFollowedAtAnySpeedOfTime) {
    // The cue ball rolls along x at 2 m/s for a second, beneath the camera after half of it.
    CameraRig rig = fixture_rig();
    rig.target = FollowPath{"cue", {0, 0, 0}, 0, 0};
    for (const double beside : {0.0, 1e-3}) {
        rig.position = fixed({1, beside, 1.5});
        for (const auto& [start, end] : std::vector<std::pair<Rational, Rational>>{
                 {0, 1}, {1, 0}, {{2, 5}, {3, 5}}, {{1, 2}, {1, 2}}, {{3, 10}, {9, 10}}}) {
            rig.time_map = {start, end};
            if (start == end && beside == 0) {
                continue;  // along `up` for the whole film
            }
            EXPECT_LT(turns_of(rig).between, 15) << start.to_double() << " " << beside;
            FilmTiming scene_clock;
            scene_clock.shutter.clock = ShutterClock::scene;
            EXPECT_LT(turns_of(rig, scene_clock).in_shutter, 20);
        }
        // To the ball, back, and over again.
        rig.time_map = {{3, 10}, {3, 10}, {{0, 1}, {1, {-1, 2}}, {2, 1}}, false};
        EXPECT_LT(turns_of(rig).between, 15);
    }
    // Averaged, ahead of the frame, and a camera that rides on the ball over a fixed target.
    rig.time_map = {0, 1};
    rig.position = fixed({1, 0, 1.5});
    rig.target = FollowPath{"cue", {0, 0, 0}, 0.2, 0.1};
    EXPECT_LT(turns_of(rig).between, 15);
    rig.position = FollowPath{"cue", {0, 0, 1}, 0, 0};
    rig.target = fixed({1, 0, 0});
    EXPECT_LT(turns_of(rig).between, 15);
}

TEST(SteadyUp, PassageAtAnEndOfThePath_IsTheSameWayUpWithinAnExposure) {
    // The shutter of the first frame opens before the path's start, on the other side.
    EXPECT_LT(turns_of(flight({0, 0, 1}, {1, 0, 1})).in_shutter, 5);
    EXPECT_LT(turns_of(flight({-1, 0, 1}, {0, 0, 1})).in_shutter, 5);
    EXPECT_LT(turns_of(flight({-0.005, 0, 1}, {1, 0, 1})).in_shutter, 5);
    EXPECT_LT(turns_of(flight({-1, 0, 1}, {0.005, 0, 1})).in_shutter, 5);
}

TEST(SteadyUp, ViewThatOnlyTouchesUp_ComesBackUpright) {
    CameraRig rig = fixture_rig();
    rig.position = BezierPath{{{{-0.5, 0, 1}, "", 0}, {{0.5, 0, 1}, "", 0}, {{-0.5, 0, 1}, "", 0}}};
    rig.target = fixed({0, 0, 0});
    EXPECT_LT(turns_of(rig).between, 10);
    EXPECT_EQ(steady_state(rig, {7, 4}), plain_state(rig, {7, 4}));
}

TEST(SteadyUp, RetimedAndReversedFilms_ShowTheSameViews) {
    const std::vector<CameraRig> film =
        with_fitted_paths(std::vector{flight_over(1e-3)}, fixture_timeline());
    RetimeOptions backwards;
    backwards.reverse = true;
    const std::vector<CameraRig> reversed = retime_rigs(film, backwards);
    for (int n = 1; n < 48; ++n) {
        const PlannedFrame a = plan_frame(n, film, {}, fixture_timeline());
        const PlannedFrame b = plan_frame(48 - n, reversed, {}, fixture_timeline());
        EXPECT_EQ(a.camera_open, b.camera_open) << n;
        EXPECT_EQ(a.camera_close, b.camera_close) << n;
    }
    // Also of rigs whose turns are found only after they were retimed.
    CameraRig plain = flight_over(1e-3);
    RetimeOptions slow;
    slow.from = Rational(3, 2);
    slow.to = 2;
    slow.speed = Rational(1, 8);
    const render::CameraState late =
        steady_state(retime_rigs(std::span(&plain, 1), slow).front(), 0);
    const render::CameraState same = steady_state(plain, {3, 2});
    EXPECT_LT((late.up - same.up).length(), 1e-9);
}

TEST(SteadyUp, CameraAtATime_DoesNotDependOnWhatElseIsAsked) {
    const std::vector<CameraRig> film =
        with_fitted_paths(std::vector{flight_over(1e-3)}, fixture_timeline());
    const PlannedFrame late = plan_frame(40, film, {}, fixture_timeline());
    FilmTiming quick;
    quick.fps = 120;
    quick.shutter.exposure = 0;
    FilmTiming still;
    still.shutter.exposure = 0;
    for (int n = 0; n < 48; ++n) {
        EXPECT_EQ(plan_frame(n, film, still, fixture_timeline()).camera_open,
                  plan_frame(5 * n, film, quick, fixture_timeline()).camera_open);
    }
    const std::vector<CameraRig> again =
        with_fitted_paths(std::vector{flight_over(1e-3)}, fixture_timeline());
    EXPECT_EQ(plan_frame(40, again, {}, fixture_timeline()).camera_open, late.camera_open);
}

TEST(SteadyUp, JumpOfTheTarget_IsACut) {
    // The ball is put down on the other side of the point beneath the camera.
    sim::Timeline timeline;
    timeline.end_time = 2;
    timeline.tracks.emplace_back(
        "cue", std::vector{fixture_key(0, {0.4, 0, 0}, {0, 0, 0}, {0, 0, 0}),
                           fixture_key(1, {0.4, 0, 0}, {0, 0, 0}, {0, 0, 0}),
                           fixture_key(sim::time_after_jump(1), {-0.4, 0, 0}, {0, 0, 0}, {0, 0, 0}),
                           fixture_key(2, {-0.4, 0, 0}, {0, 0, 0}, {0, 0, 0})});
    CameraRig rig = fixture_rig();
    rig.position = fixed({0, 0, 1});
    rig.target = FollowPath{"cue", {0, 0, 0}, 0, 0};
    EXPECT_TRUE(find_up_turns(rig, timeline).empty());
    EXPECT_GT(turns_of(rig, {}, timeline).between, 90);  // which check warns of
}

TEST(SteadyUp, HandAboveTheTarget_TurnsTheWholeCamera) {
    CameraRig rig = flight({-0.02, 0.01, 1}, {-0.02, 0.02, 1});
    rig.shake = Shake{};
    EXPECT_LT(turns_of(rig).between, 3);
    rig = flight_over(0);
    rig.shake = Shake{};
    EXPECT_LT(turns_of(rig).between, 15);
    // Away from the vertical a hand moves the camera as it always did.
    rig = flight({-0.5, 0, 1}, {-0.5, 0.2, 1});
    rig.shake = Shake{};
    EXPECT_EQ(steady_state(rig, 1).up, Vec3(0, 0, 1));
}

TEST(SteadyUp, CameraThroughItsTarget_HasViewsOnBothSides) {
    const CameraRig rig = flight({-1, 0, 0.5}, {1.01, 0, -0.505});
    EXPECT_GT(turns_of(rig).between, 90);  // which check warns of
}

}  // namespace
}  // namespace carom::pipeline
