// Tests of the paths other than Bezier curves, and of the lens.
#include "pipeline/camera/camera_path.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "pipeline/camera/easing.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/rig_state.h"
#include "tests/pipeline/camera/rig_fixture.h"

namespace carom::pipeline {
namespace {

constexpr double kPi = std::numbers::pi;

RigInstant at(double done, double scene_time = 0) {
    return {{done, 1 - done}, scene_time};
}

Vec3 place(const CameraPath& path, double done, double scene_time = 0) {
    return path_position(path, at(done, scene_time), fixture_timeline());
}

TEST(Orbit, Circle_HasItsCentreAndRadius) {
    OrbitPath path;
    path.around = ControlPoint{{1, 2, 3}, "", 0};
    path.radii = {0.5, 0.5};
    path.start_angle = kPi / 2;
    path.end_angle = 3 * kPi / 2;
    EXPECT_LT((place(path, 0) - Vec3(1, 2.5, 3)).length(), 1e-15);
    EXPECT_LT((place(path, 0.5) - Vec3(0.5, 2, 3)).length(), 1e-15);
    EXPECT_LT((place(path, 1) - Vec3(1, 1.5, 3)).length(), 1e-15);
    EXPECT_LT((place(path, 1.5) - Vec3(1.5, 2, 3)).length(), 1e-15);  // continues around the circle
}

TEST(Orbit, MovingObject_IsFollowedByTheOrbit) {
    OrbitPath path;
    path.around = FollowPath{"cue", {0, 0, 1}, 0, 0};
    path.radii = {2, 1};
    EXPECT_LT((place(path, 0, 0.5) - Vec3(3, 0, 1)).length(), 1e-15);
    EXPECT_LT((place(path, 0.25, 1) - Vec3(2, 1, 1)).length(), 1e-15);
}

TEST(Orbit, Turn_RotatesItsPlane) {
    OrbitPath path;
    path.around = ControlPoint{{0, 0, 0}, "", 0};
    path.turn.setAxisAngle({1, 0, 0}, kPi / 2);  // y becomes vertical
    EXPECT_LT((place(path, 0.25) - Vec3(0, 0, 1)).length(), 1e-15);
}

TEST(Orbit, EvenPaceOnAnEllipse_CoversEqualDistances) {
    OrbitPath path;
    path.around = ControlPoint{{0, 0, 0}, "", 0};
    path.radii = {2, 0.5};
    path.even_pace = true;
    // A quarter of the ellipse by symmetry, where the position without even pace is the same.
    EXPECT_LT((place(path, 0.25) - Vec3(0, 0.5, 0)).length(), 1e-8);
    const int steps = 2000;
    double longest = 0;
    double shortest = 1e9;
    Vec3 before = place(path, 0);
    for (int i = 1; i <= steps; ++i) {
        const Vec3 now = place(path, double(i) / steps);
        longest = std::max(longest, (now - before).length());
        shortest = std::min(shortest, (now - before).length());
        before = now;
    }
    // A chord is shorter than its arc by at most (arc / smallest radius)^2 / 24, 1e-4 here.
    EXPECT_NEAR(shortest / longest, 1, 2e-4);
}

TEST(Follow, LookAhead_IsTheLaterPosition) {
    EXPECT_LT((place(FollowPath{"cue", {0, 0, 1}, 0, 0.25}, 0, 0.5) - Vec3(1.5, 0, 1)).length(),
              1e-15);
    EXPECT_LT((place(FollowPath{"cue", {0, 0, 0}, 0, -0.5}, 0, 0.75) - Vec3(0.5, 0, 0)).length(),
              1e-15);
}

TEST(Paths, WithEasing_StartAndEndGently) {
    const std::vector<ControlPoint> line{{{0, 0, 0}, "", 0}, {{1, 0, 0}, "", 0}};
    EXPECT_DOUBLE_EQ(place(BezierPath{line, false, Easing::smooth}, 0.25).x, 0.15625);
    EXPECT_DOUBLE_EQ(place(SplinePath{line, false, Easing::smooth}, 0.25).x, 0.15625);
    EXPECT_NEAR(place(SplinePath{line, true, Easing::smooth}, 0.25).x, 0.15625, 1e-9);
}

TEST(Paths, Reversed_GiveTheSameBits) {
    const std::vector<ControlPoint> points{
        {{0.1, 0.7, 0}, "", 0}, {{0, 0.1, 0.5}, "cue", 0.7}, {{2.1, 3.3, 0.2}, "", 0}};
    OrbitPath orbit;
    orbit.around = ControlPoint{{0.3, 0, 0.1}, "", 0};
    orbit.radii = {0.7, 1.3};
    orbit.start_angle = 0.3;
    orbit.end_angle = 5;
    for (const bool even : {false, true}) {
        orbit.even_pace = even;
        OrbitPath orbit_back = orbit;
        std::swap(orbit_back.start_angle, orbit_back.end_angle);
        const std::vector<std::pair<CameraPath, CameraPath>> pairs{
            {SplinePath{points, even}, SplinePath{{points.rbegin(), points.rend()}, even}},
            {AlongPath{"cue", 0.2, 3, {0, 0, 1}, even}, AlongPath{"cue", 3, 0.2, {0, 0, 1}, even}},
            {orbit, orbit_back}};
        for (const auto& [forward, backward] : pairs) {
            for (int i = -2; i <= 26; i += 4) {
                const Progress progress{i / 24.0, (24 - i) / 24.0};
                EXPECT_EQ(path_position(forward, {progress, 0}, fixture_timeline()),
                          path_position(backward, {progress.reversed(), 0}, fixture_timeline()))
                    << forward.index() << " " << i;
            }
        }
    }
}

TEST(Easing, Bezier_IsTheCurveOfItsControlPoints) {
    // x(s) = s for x1 = 1/3, x2 = 2/3: y is the cubic Bezier polynomial of 0, y1, y2, 1.
    const Easing curve(1.0 / 3, 0.9, 2.0 / 3, -0.4);
    for (double t = 0; t <= 1; t += 1.0 / 16) {
        const double r = 1 - t;
        EXPECT_NEAR(ease({t, r}, curve).done, 3 * r * r * t * 0.9 - 3 * r * t * t * 0.4 + t * t * t,
                    1e-15);
    }
    // Symmetric about its middle, steep there, and with zero slope at the ends.
    const Easing symmetric(0.5, 0, 0.5, 1);
    EXPECT_NEAR(ease({0.5, 0.5}, symmetric).done, 0.5, 1e-15);
    EXPECT_NEAR(ease({0.2, 0.8}, symmetric).done, 1 - ease({0.8, 0.2}, symmetric).done, 1e-15);
    EXPECT_EQ(ease({-0.1, 1.1}, symmetric).done, 0);
    // Beyond the ends it continues with the slope at the end.
    const Easing quick(0.25, 0.5, 0.5, 1);
    EXPECT_DOUBLE_EQ(ease({-0.1, 1.1}, quick).done, -0.2);
    EXPECT_DOUBLE_EQ(ease({1.1, -0.1}, quick).done, 1);
    EXPECT_NEAR(ease({1e-9, 1 - 1e-9}, quick).done, 2e-9, 1e-15);
}

TEST(Lens, FocalLength_GivesTheFieldOfViewOfItsSensor) {
    CameraRig rig = fixture_rig();
    rig.focal_length = {0.012, 0.024};
    EXPECT_DOUBLE_EQ(camera_state(rig, at(0), fixture_timeline()).vertical_fov, kPi / 2);
    EXPECT_DOUBLE_EQ(camera_state(rig, at(0.5), fixture_timeline()).vertical_fov,
                     2 * std::atan(0.012 / 0.018));
    rig.sensor_height = 0.012;
    EXPECT_DOUBLE_EQ(camera_state(rig, at(0), fixture_timeline()).vertical_fov, 2 * std::atan(0.5));
    rig.aperture = {Aperture{4, true}, Aperture{4, true}};
    EXPECT_DOUBLE_EQ(camera_state(rig, at(1), fixture_timeline()).lens_radius, 0.003);
}

TEST(Lens, UpVectorAndBlades_ChangeFromStartToEnd) {
    CameraRig rig = fixture_rig();
    rig.up = {{0, 0, 1}, {1, 0, 1}};
    rig.blades = {5, 9};
    EXPECT_EQ(camera_state(rig, at(0.5), fixture_timeline()).up, Vec3(0.5, 0, 1));
    EXPECT_EQ(camera_state(rig, at(0.4), fixture_timeline()).blades, 7);
    // The number of blades rounds to 6 only during this exposure, but it is constant in an
    // exposure.
    rig.blades = {5, 6};
    FilmTiming timing;
    timing.shutter.exposure = {1, 24};
    const PlannedFrame frame = plan_frame(24, std::vector{rig}, timing, fixture_timeline());
    EXPECT_EQ(frame.camera_open.blades, 6);
    EXPECT_EQ(frame.camera_close.blades, 6);
    EXPECT_EQ(plan_frame(23, std::vector{rig}, timing, fixture_timeline()).camera_close.blades, 5);
}

}  // namespace
}  // namespace carom::pipeline
