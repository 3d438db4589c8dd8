// Cameras that fit their picture to points, and fields of view along either side.
#include "pipeline/camera/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "pipeline/camera/exposure.h"
#include "pipeline/camera/rig_state.h"
#include "pipeline/camera/view_axes.h"
#include "tests/pipeline/camera/rig_fixture.h"

namespace carom::pipeline {
namespace {

/// The corners of a box of 2 m x 1 m x 0.1 m on the ground, around the origin.
std::vector<Vec3> box_corners() {
    std::vector<Vec3> corners;
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-0.5, 0.5}) {
            corners.emplace_back(x, y, 0);
            corners.emplace_back(x, y, 0.1);
        }
    }
    return corners;
}

/// The largest |x| and |y| of the points in the picture, in units of half its sides.
Vec2 extent(const render::CameraState& camera, double aspect, const std::vector<Vec3>& points) {
    const ViewAxes axes = view_axes(camera);
    const double half = std::tan(camera.vertical_fov / 2);
    Vec2 most(0, 0);
    for (const Vec3& point : points) {
        const Vec3 from = point - camera.position;
        const double depth = axes.ahead.dot(from);
        EXPECT_GT(depth, 0);
        most.x = std::max(most.x, std::abs(axes.right.dot(from)) / (depth * half * aspect));
        most.y = std::max(most.y, std::abs(axes.up.dot(from)) / (depth * half));
    }
    return most;
}

TEST(Framing, FromStraightAbove_HasTheHeightOfTheClosedForm) {
    render::CameraState camera;
    camera.position = {0, 0, 7};
    camera.up = {0, 1, 0};
    camera.vertical_fov = 0.6;
    const Framing framing{box_corners(), 0.05};
    const double half = 0.9 * std::tan(0.3);
    // Of a picture of 16:9 the height decides, of an upright one the width.
    EXPECT_NEAR(framed(camera, framing, 16.0 / 9).position.z,
                0.1 + std::max(0.5 / half, 1 / (half * 16 / 9)), 1e-12);
    EXPECT_NEAR(framed(camera, framing, 9.0 / 16).position.z, 0.1 + 1 / (half * 9 / 16), 1e-12);
    EXPECT_EQ(framed(camera, framing, 1).target, camera.target);
}

TEST(Framing, FromAnywhere_TouchesTheMarginAndKeepsTheDirection) {
    const std::vector<Vec3> corners = box_corners();
    for (const double aspect : {16.0 / 9, 1.0, 9.0 / 16, 2.39}) {
        for (int i = 0; i < 24; ++i) {
            render::CameraState camera;
            const double angle = i * std::numbers::pi / 12;
            camera.position = {3 * std::cos(angle), 3 * std::sin(angle), 0.3 + 0.1 * i};
            camera.target = {0.2, -0.1, 0.05 * (i % 3)};
            camera.roll = 0.1 * (i % 5);
            camera.vertical_fov = 0.3 + 0.05 * (i % 7);
            const render::CameraState fit = framed(camera, {corners, 0.04}, aspect);
            const Vec2 most = extent(fit, aspect, corners);
            EXPECT_NEAR(std::max(most.x, most.y), 1 - 2 * 0.04, 1e-12);
            const Vec3 before = (camera.target - camera.position).normalized();
            const Vec3 after = (fit.target - fit.position).normalized();
            EXPECT_NEAR((before - after).length(), 0, 1e-12);
            EXPECT_EQ(fit.vertical_fov, camera.vertical_fov);
            EXPECT_EQ(fit.roll, camera.roll);
        }
    }
}

TEST(Framing, TargetInFrontOfThePoints_IsMovedAheadOfTheCamera) {
    render::CameraState camera;
    camera.position = {0, -100, 1};
    camera.target = {0, -90, 1};
    const render::CameraState fit = framed(camera, {box_corners(), 0}, 1);
    EXPECT_GT(fit.position.y, camera.target.y);
    EXPECT_NEAR((fit.target - fit.position).length(), 0.01, 1e-12);
    EXPECT_NEAR(extent(fit, 1, box_corners()).x, 1, 1e-12);
}

TEST(Framing, OfARig_FollowsItsPathAndItsFieldOfView) {
    CameraRig rig = fixture_rig();
    rig.position = BezierPath{{{{0, -4, 1}, "", 0}, {{-4, -1, 2}, "", 0}}};
    rig.fov = {0.8, 0.4};
    rig.framing = Framing{box_corners(), 0.1};
    rig.aspect = 0.75;
    for (int i = 0; i <= 8; ++i) {
        const render::CameraState camera =
            camera_state(rig, {progress_at(rig, Rational(i, 4)), 0}, fixture_timeline());
        const Vec2 most = extent(camera, rig.aspect, box_corners());
        EXPECT_NEAR(std::max(most.x, most.y), 0.8, 1e-12);
    }
}

double vertical_fov(CameraRig rig, FovAxis axis, double aspect) {
    rig.fov_axis = axis;
    rig.aspect = aspect;
    return camera_state(rig, {{0, 1}, 0}, fixture_timeline()).vertical_fov;
}

TEST(FovAxis, OfEachAspect_IsTheNamedSide) {
    CameraRig rig = fixture_rig();
    rig.fov = {0.9, 0.9};
    const auto of_width = [](double aspect) { return 2 * std::atan(std::tan(0.45) / aspect); };
    for (const double aspect : {16.0 / 9, 9.0 / 16}) {
        EXPECT_EQ(vertical_fov(rig, FovAxis::vertical, aspect), 0.9);
        EXPECT_NEAR(vertical_fov(rig, FovAxis::horizontal, aspect), of_width(aspect), 1e-15);
    }
    EXPECT_NEAR(vertical_fov(rig, FovAxis::wider, 16.0 / 9), of_width(16.0 / 9), 1e-15);
    EXPECT_EQ(vertical_fov(rig, FovAxis::wider, 9.0 / 16), 0.9);
    EXPECT_EQ(vertical_fov(rig, FovAxis::wider, 1), 0.9);
}

TEST(IsInPicture, BallAtAnEdge_IsInsideWhileAPartOfItIs) {
    render::CameraState camera;  // along y, fields of view of 90 degrees
    camera.position = {0, 0, 0};
    camera.target = {0, 1, 0};
    camera.vertical_fov = std::numbers::pi / 2;
    const auto is_seen = [&](const Vec3& centre, double radius) {
        return is_in_picture(camera, 1, centre, radius);
    };
    EXPECT_TRUE(is_seen({0, 2, 0}, 0));
    EXPECT_TRUE(is_seen({1.99, 2, -1.99}, 0));
    EXPECT_FALSE(is_seen({2.01, 2, 0}, 0));
    EXPECT_FALSE(is_seen({0, 2, 2.01}, 0));
    EXPECT_FALSE(is_seen({0, -2, 0}, 0.5));
    // The distance from the plane of the right edge is (x - y) / sqrt(2).
    EXPECT_TRUE(is_seen({2 + 0.2 * std::sqrt(2.0), 2, 0}, 0.201));
    EXPECT_FALSE(is_seen({2 + 0.2 * std::sqrt(2.0), 2, 0}, 0.199));
}

}  // namespace
}  // namespace carom::pipeline
