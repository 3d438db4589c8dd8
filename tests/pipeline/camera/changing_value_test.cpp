// Values that are given by keys.
#include "pipeline/camera/changing_value.h"

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/camera/exposure.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/retime.h"
#include "pipeline/camera/rig_state.h"
#include "tests/pipeline/camera/rig_fixture.h"

namespace carom::pipeline {
namespace {

/// A rig from 1 s to 3 s of the film with a field of view of 0.4, 0.8 and 0.2 at 3/2, 2 and 5/2 s.
CameraRig keyed_rig(Easing easing = Easing::linear) {
    CameraRig rig = fixture_rig();
    rig.video_start = 1;
    rig.video_end = 3;
    rig.fov = {
        0.4, 0.2, easing, {{Rational(3, 2), 0.4}, {Rational(2), 0.8}, {Rational(5, 2), 0.2}}};
    return rig;
}

double fov_at(const CameraRig& rig, const Rational& video_time) {
    return value_at(rig.fov, rig, progress_at(rig, video_time));
}

TEST(KeyedValue, AtAKey_IsExactlyItsValue) {
    const CameraRig rig = keyed_rig(Easing::smooth);
    EXPECT_EQ(fov_at(rig, Rational(3, 2)), 0.4);
    EXPECT_EQ(fov_at(rig, Rational(2)), 0.8);
    EXPECT_EQ(fov_at(rig, Rational(5, 2)), 0.2);
}

TEST(KeyedValue, AtAKeyOfManyDigits_IsExactlyItsValue) {
    CameraRig rig = keyed_rig();
    rig.video_start = Rational(1001, 24000);
    rig.video_end = Rational(7777, 1000);
    for (const Rational& time : {Rational(4004, 24000), Rational(10, 7), Rational(22, 3)}) {
        rig.fov.keys = {{Rational(1, 10), 0.1}, {time, 0.7}, {Rational(15, 2), 0.3}};
        EXPECT_EQ(fov_at(rig, time), 0.7);
    }
}

TEST(KeyedValue, BeforeAndAfterAllKeys_IsConstant) {
    const CameraRig rig = keyed_rig();
    for (const Rational& time : {Rational(0), Rational(1), Rational(7, 5)}) {
        EXPECT_EQ(fov_at(rig, time), 0.4);
    }
    for (const Rational& time : {Rational(13, 5), Rational(3), Rational(10)}) {
        EXPECT_EQ(fov_at(rig, time), 0.2);
    }
}

TEST(KeyedValue, BetweenTwoKeys_IsEasedFromOneToTheOther) {
    EXPECT_DOUBLE_EQ(fov_at(keyed_rig(), Rational(7, 4)), 0.6);
    EXPECT_DOUBLE_EQ(fov_at(keyed_rig(), Rational(17, 8)), 0.65);
    // 3 u^2 - 2 u^3 at u = 1/4 is 5/32.
    EXPECT_DOUBLE_EQ(fov_at(keyed_rig(Easing::smooth), Rational(13, 8)), 0.4 + 0.4 * 5 / 32);
    EXPECT_DOUBLE_EQ(fov_at(keyed_rig(Easing::smooth), Rational(17, 8)), 0.8 - 0.6 * 5 / 32);
}

TEST(KeyedValue, Focus_MixesDistancesAndObjects) {
    CameraRig rig = fixture_rig();  // at (0, -4, 1), looking at the origin
    Focus one;
    one.object = "one";  // at (3, 1, 0)
    Focus near;
    near.distance = 2;
    rig.focus.keys = {{Rational(0), one}, {Rational(1), near}, {Rational(2), Focus{}}};
    const auto focus_at = [&](const Rational& time) {
        return camera_state(rig, {progress_at(rig, time), 0}, fixture_timeline()).focus_distance;
    };
    const double of_one = Vec3(3, 5, -1).dot(Vec3(0, 4, -1)) / std::sqrt(17.0);
    EXPECT_DOUBLE_EQ(focus_at(0), of_one);
    EXPECT_DOUBLE_EQ(focus_at(Rational(1, 4)), 0.75 * of_one + 0.25 * 2);
    EXPECT_DOUBLE_EQ(focus_at(1), 2);
    EXPECT_DOUBLE_EQ(focus_at(Rational(3, 2)), 1 + std::sqrt(17.0) / 2);  // half to the target
}

TEST(KeyedValue, FocusOnAnObjectBehindTheCamera_IsFoundBetweenItsKeysOnly) {
    CameraRig rig = fixture_rig();
    rig.position = BezierPath{{{{3, 2, 0.5}, "", 0}}};
    rig.target = BezierPath{{{{3, 4, 0.5}, "", 0}}};  // 'one' is behind
    Focus one;
    one.object = "one";
    Focus near;
    near.distance = 2;
    rig.focus.keys = {{Rational(0), near}, {Rational(1), one}, {Rational(2), near}};
    const auto behind_at = [&](const Rational& time) {
        return find_focus_behind_camera(rig, {progress_at(rig, time), 0}, fixture_timeline());
    };
    EXPECT_TRUE(behind_at(0).empty());
    EXPECT_EQ(behind_at(Rational(1, 2)), std::vector<std::string>{"one"});
    EXPECT_EQ(behind_at(1), std::vector<std::string>{"one"});
    EXPECT_TRUE(behind_at(2).empty());
}

TEST(KeyedValue, FNumbers_AreMixedAsFNumbers) {
    CameraRig rig = fixture_rig();
    rig.aperture.keys = {{Rational(0), {2, true}}, {Rational(1), {4, true}}};
    const render::CameraState camera =
        camera_state(rig, {progress_at(rig, Rational(1, 2)), 0}, fixture_timeline());
    EXPECT_DOUBLE_EQ(camera.lens_radius, lens_radius({3, true}, 0.7));
}

TEST(KeyedValue, RetimedRig_HasTheSameValuesAtTheSameScenes) {
    const CameraRig rig = keyed_rig(Easing::smooth);  // shows 0 s to 2 s in 1 s to 3 s
    RetimeOptions slower;
    slower.speed = Rational(1, 4);
    const CameraRig slow = retime_rigs(std::span(&rig, 1), slower).front();
    EXPECT_EQ(slow.video_end, Rational(8));
    for (int i = 0; i <= 16; ++i) {
        EXPECT_EQ(fov_at(slow, Rational(i, 2)), fov_at(rig, Rational(1) + Rational(i, 8)));
    }
}

TEST(KeyedValue, PartOfARig_HasTheValuesOfItsPart) {
    const CameraRig rig = keyed_rig();
    RetimeOptions part;
    part.from = Rational(3, 4);
    part.to = Rational(5, 4);
    const CameraRig cut = retime_rigs(std::span(&rig, 1), part).front();
    EXPECT_EQ(cut.video_start, Rational(0));
    EXPECT_EQ(cut.video_end, Rational(1, 2));
    EXPECT_DOUBLE_EQ(fov_at(cut, 0), fov_at(rig, Rational(7, 4)));
    EXPECT_EQ(fov_at(cut, Rational(1, 4)), 0.8);
    EXPECT_DOUBLE_EQ(fov_at(cut, Rational(1, 2)), fov_at(rig, Rational(9, 4)));
    part.speed = Rational(1, 2);  // of the part that was cut, and of a part of it
    const CameraRig twice = retime_rigs(std::span(&cut, 1), part).front();
    EXPECT_EQ(fov_at(twice, Rational(1, 2)), 0.8);
}

TEST(KeyedValue, ReversedRig_HasTheSameBits) {
    CameraRig rig = keyed_rig(Easing(0.3, 0.1, 0.6, 0.8));
    rig.shake.emplace();
    RetimeOptions backwards;
    backwards.reverse = true;
    const CameraRig reversed = retime_rigs(std::span(&rig, 1), backwards).front();
    const auto state = [](const CameraRig& of, const Rational& time) {
        return camera_state(of, {progress_at(of, time), 0}, fixture_timeline());
    };
    for (int i = 0; i <= 40; ++i) {
        const Rational time(i, 20);
        EXPECT_EQ(state(reversed, time), state(rig, Rational(3) - time)) << i;
    }
}

}  // namespace
}  // namespace carom::pipeline
