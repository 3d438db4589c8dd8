// What the lens of a rig does to the camera of a frame.
#include "pipeline/camera/lens.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/framing.h"
#include "pipeline/camera/rig_state.h"
#include "pipeline/camera/view_axes.h"
#include "render/camera/thin_lens_camera.h"
#include "tests/pipeline/camera/rig_fixture.h"

namespace carom::pipeline {
namespace {

/// A lens of `focal_length` that is focused at `distance`, on a sensor 24 mm high.
CameraRig lens_rig(double focal_length, double distance) {
    CameraRig rig = fixture_rig();
    rig.focal_length = Eased<double>{focal_length, focal_length};
    rig.focus = {Focus{distance, ""}, Focus{distance, ""}};
    rig.aperture = {{2.8, true}, {2.8, true}};
    return rig;
}

render::CameraState state_of(const CameraRig& rig) {
    return camera_state(rig, {{0, 1}, 0}, fixture_timeline());
}

// The distance of the image from a thin lens that is moved as a whole is f d / (d - f).
TEST(Breathing, SimpleLens_HasTheFieldOfItsImageDistance) {
    for (const auto& [f, d] : {std::pair{0.05, 1.0}, std::pair{0.1, 1.0}, std::pair{0.035, 3.0}}) {
        CameraRig rig = lens_rig(f, d);
        rig.lens.breathing = 1;
        const double image = f * d / (d - f);
        EXPECT_NEAR(state_of(rig).vertical_fov, 2 * std::atan(0.012 / image), 1e-12);
    }
}

TEST(Breathing, FiftyMillimetresAtOneMetre_AreFivePerCent) {
    EXPECT_NEAR(narrowing(0.05, 1, 1), 1.0526, 1e-4);
    EXPECT_NEAR(narrowing(0.05, 1, 0.2), 1.0105, 1e-4);
    EXPECT_EQ(narrowing(0.05, 1, 0), 1);
    EXPECT_EQ(narrowing(0.05, 0.01, 1), 2) << "nearer than an image has";
}

TEST(Breathing, FNumber_IsThatOfTheFocalLength) {
    CameraRig rig = lens_rig(0.05, 1);
    const double radius = state_of(rig).lens_radius;
    rig.lens.breathing = 1;
    EXPECT_EQ(state_of(rig).lens_radius, radius);
    EXPECT_NEAR(radius, 0.05 / 5.6, 1e-15);
}

TEST(Breathing, None_LeavesTheStateAsItIs) {
    CameraRig rig = lens_rig(0.05, 1);
    const render::CameraState before = state_of(rig);
    rig.lens.breathing = 0;
    rig.lens.look = {1, 0.001};
    EXPECT_EQ(state_of(rig), before);
    EXPECT_FALSE(before.lens.has_value());
}

TEST(Breathing, WithFraming_KeepsThePointsInside) {
    CameraRig rig = lens_rig(0.05, 1);
    rig.focus = {Focus{}, Focus{}};  // the target
    rig.lens.breathing = 1;
    rig.aspect = 1;
    rig.framing = Framing{{{-1, 0, 0}, {1, 0, 0}, {0, 0.4, 0.3}}, 0};
    const render::CameraState state = state_of(rig);
    const ViewAxes axes = view_axes(state);
    double most = 0;
    for (const Vec3& point : rig.framing->points) {
        const Vec3 from = point - state.position;
        most = std::max(most, std::abs(axes.right.dot(from)) / axes.ahead.dot(from));
    }
    EXPECT_NEAR(most, std::tan(state.vertical_fov / 2), 1e-5);
}

TEST(LensShape, OfTheRig_IsThatOfBothEndsOfTheExposure) {
    CameraRig rig = fixture_rig();
    rig.lens.shape.squeeze = 0.5;
    rig.lens.look.falloff = 0.7;
    const PlannedFrame frame = plan_frame_of(3, rig, FilmTiming(), fixture_timeline());
    ASSERT_TRUE(frame.camera_open.lens && frame.camera_close.lens);
    EXPECT_EQ(frame.camera_open.lens->squeeze, 0.5);
    EXPECT_EQ(frame.camera_close.lens, frame.camera_open.lens);
    EXPECT_EQ(frame.look.falloff, 0.7);
}

/// The farthest of the points from the picture's centre, in halves of its sides.
double farthest(const render::CameraState& state, const std::vector<Vec3>& points) {
    const render::ThinLensCamera lens(state, state, 1600, 900, 0, render::PixelFilter::box, 1);
    double most = 0;
    for (const Vec3& point : points) {
        const Imath::V2f place = *lens.project(Imath::V3f(point), 0);
        most = std::max({most, std::abs(static_cast<double>(place.x) / 800 - 1),
                         std::abs(static_cast<double>(place.y) / 450 - 1)});
    }
    return most;
}

TEST(Framing, WithDistortion_KeepsThePointsInsideAndIsNotWasteful) {
    const Framing framing{{{-1, -0.5, 0}, {1, -0.5, 0}, {-1, 0.5, 0}, {1, 0.5, 0}}, 0};
    for (const double distortion : {-0.05, 0.05}) {
        render::CameraState state;
        state.position = {0.5, -3, 2};
        state.lens = render::LensShape{.distortion = distortion};
        const double most = farthest(framed(state, framing, 16.0 / 9), framing.points);
        EXPECT_LE(most, 1 + 1e-5) << distortion;
        EXPECT_GE(most, 0.94) << distortion;
    }
}

// In a corner of the picture, which a barrel shows from farther outside.
TEST(IsInPicture, WithABarrel_IsTrueOfWhatItDrawsIn) {
    render::CameraState state;
    state.position = {0, -3, 0};
    state.target = {0, 0, 0};
    const double half = std::tan(state.vertical_fov / 2);
    const Vec3 corner(1.04 * 3 * half, 0, 1.04 * 3 * half);
    EXPECT_FALSE(is_in_picture(state, 1, corner, 1e-6));
    state.lens = render::LensShape{.distortion = -0.05};
    EXPECT_TRUE(is_in_picture(state, 1, corner, 1e-6));
    const render::ThinLensCamera lens(state, state, 100, 100, 0, render::PixelFilter::box, 1);
    EXPECT_LT(lens.project(Imath::V3f(corner), 0)->x, 100);
}

}  // namespace
}  // namespace carom::pipeline
