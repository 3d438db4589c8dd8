#include "render/camera/thin_lens_camera.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/render/sampling/warp_densities.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 360;

CameraState some_camera() {
    CameraState state;
    state.position = Vec3(-1.5, -2, 1.2);
    state.target = Vec3(0.3, 0.1, 0.05);
    state.vertical_fov = 0.6;
    state.focus_distance = 2.2;
    return state;
}

ThinLensCamera static_camera(const CameraState& state, PixelFilter filter = PixelFilter::box,
                             double filter_width = 1) {
    return {state, state, kWidth, kHeight, 0, filter, filter_width};
}

CameraSample centre() {
    return {V2f(0.5f, 0.5f), V2f(0.5f, 0.5f), 0};
}

CameraSample random_sample(test::TestRandom& random) {
    CameraSample sample;
    sample.pixel = V2f{random.unit(), random.unit()};
    sample.lens = V2f{random.unit(), random.unit()};
    sample.time = random.unit();
    return sample;
}

/// Where the ray crosses the plane at `distance` along the optical axis.
V3f at_depth(const ThinLensCamera& camera, const Ray& ray, float distance, float time = 0) {
    const CameraFrame frame = camera.frame_at(time);
    const float start = (ray.origin - frame.position).dot(frame.forward);
    const float t = (distance - start) / ray.direction.dot(frame.forward);
    return ray.origin + t * ray.direction;
}

TEST(ThinLensCamera, PinholeAtOrigin_KnownPointsProjectWhereTheyShould) {
    CameraState state;
    state.position = Vec3(0, 0, 0);
    state.target = Vec3(0, 1, 0);
    state.up = Vec3(0, 0, 1);
    state.vertical_fov = 2 * std::atan(0.5);  // the picture is one unit high at distance 1
    const ThinLensCamera camera = static_camera(state);
    EXPECT_NEAR((*camera.project(V3f(0, 1, 0), 0) - V2f(320, 180)).length(), 0, 1e-4);
    EXPECT_NEAR((*camera.project(V3f(0, 1, 0.5f), 0) - V2f(320, 0)).length(), 0, 1e-4);
    EXPECT_NEAR((*camera.project(V3f(0, 2, -1), 0) - V2f(320, 360)).length(), 0, 1e-4);
    // For a view along +y, +x is on the right.
    EXPECT_NEAR((*camera.project(V3f(0.5f, 1, 0), 0) - V2f(500, 180)).length(), 0, 1e-4);
    EXPECT_FALSE(camera.project(V3f(0, -1, 0), 0));
}

TEST(ThinLensCamera, PinholeRays_PassThroughThePointsTheyShow) {
    const ThinLensCamera camera = static_camera(some_camera());
    test::TestRandom random(1);
    for (int i = 0; i < 2000; ++i) {
        const CameraSample sample = random_sample(random);
        const int x = static_cast<int>(random.next() % kWidth);
        const int y = static_cast<int>(random.next() % kHeight);
        const Ray ray = camera.ray(x, y, sample);
        ASSERT_NEAR(ray.direction.length(), 1, 1e-6);
        const V2f pixel = *camera.project(ray.origin + 3.f * ray.direction, 0);
        ASSERT_NEAR(pixel.x, static_cast<float>(x) + sample.pixel.x, 2e-3);
        ASSERT_NEAR(pixel.y, static_cast<float>(y) + sample.pixel.y, 2e-3);
    }
}

TEST(ThinLensCamera, NoApertureNoShutter_ExactlyThePinholeRays) {
    // Lens and time of the sample do not change a single bit.
    const ThinLensCamera camera = static_camera(some_camera());
    test::TestRandom random(2);
    for (int i = 0; i < 2000; ++i) {
        CameraSample a = random_sample(random);
        CameraSample b = a;
        b.lens = V2f{random.unit(), random.unit()};
        b.time = random.unit();
        const Ray ray_a = camera.ray(i % kWidth, i % kHeight, a);
        const Ray ray_b = camera.ray(i % kWidth, i % kHeight, b);
        ASSERT_EQ(ray_a.origin, ray_b.origin);
        ASSERT_EQ(ray_a.direction, ray_b.direction);
        ASSERT_EQ(ray_a.origin, V3f(some_camera().position));
    }
}

TEST(ThinLensCamera, FocusPlane_IsSharpAndPerpendicularToTheAxis) {
    CameraState state = some_camera();
    state.lens_radius = 0.05;
    const ThinLensCamera lens = static_camera(state);
    state.lens_radius = 0;
    const ThinLensCamera pinhole = static_camera(state);
    test::TestRandom random(3);
    for (int i = 0; i < 2000; ++i) {
        const CameraSample sample = random_sample(random);
        const int x = i % kWidth;
        const int y = (7 * i) % kHeight;
        const V3f a = at_depth(lens, lens.ray(x, y, sample), 2.2f);
        const V3f b = at_depth(pinhole, pinhole.ray(x, y, sample), 2.2f);
        ASSERT_NEAR((a - b).length(), 0, 3e-6);
    }
}

TEST(ThinLensCamera, CircleOfConfusion_HasItsClosedForm) {
    // At depth z a point in focus at f spreads over a disk of radius A |z - f| / f.
    CameraState state = some_camera();
    state.lens_radius = 0.04;
    const ThinLensCamera camera = static_camera(state);
    test::TestRandom random(4);
    for (const float depth : {0.7f, 1.5f, 3.f, 8.f}) {
        const V3f middle = at_depth(camera, camera.ray(320, 180, centre()), depth);
        float largest = 0;
        double mean_square = 0;
        const int samples = 20'000;
        for (int i = 0; i < samples; ++i) {
            CameraSample sample = centre();
            sample.lens = V2f{random.unit(), random.unit()};
            const float r =
                (at_depth(camera, camera.ray(320, 180, sample), depth) - middle).length();
            largest = std::max(largest, r);
            mean_square += static_cast<double>(r * r) / samples;
        }
        const double radius = 0.04 * std::abs(static_cast<double>(depth) - 2.2) / 2.2;
        EXPECT_NEAR(static_cast<double>(largest), radius, 0.002 * radius) << depth;
        EXPECT_LE(static_cast<double>(largest), radius * 1.0001) << depth;
        // Uniform over the disk: the mean square is half the radius squared, its standard error
        // r^2 / sqrt(12 n).
        EXPECT_NEAR(mean_square, radius * radius / 2,
                    4 * radius * radius / std::sqrt(12.0 * samples));
    }
}

TEST(ThinLensCamera, Blades_LensPointsFormThePolygon) {
    CameraState state = some_camera();
    state.lens_radius = 0.05;
    state.blades = 5;
    state.blade_rotation = 0.3;
    const ThinLensCamera camera = static_camera(state);
    const CameraFrame frame = camera.frame_at(0);
    test::TestRandom random(5);
    float largest = 0;
    for (int i = 0; i < 20'000; ++i) {
        const V3f on_lens = camera.ray(10, 20, random_sample(random)).origin - frame.position;
        const float x = on_lens.dot(frame.right) / 0.05f;
        const float y = on_lens.dot(frame.up) / 0.05f;
        ASSERT_NEAR(on_lens.dot(frame.forward), 0, 1e-6);
        largest = std::max(largest, std::hypot(x, y));
        for (int k = 0; k < 5; ++k) {
            // The distance of every edge from the centre is cos(pi / 5).
            const float angle = 0.3f + 2 * kPi * (static_cast<float>(k) + 0.5f) / 5;
            ASSERT_LE(x * std::cos(angle) + y * std::sin(angle), std::cos(kPi / 5) + 1e-4f);
        }
    }
    EXPECT_GT(largest, 0.98f);
}

TEST(ThinLensCamera, MovingCamera_EndsAreTheStates) {
    const CameraState open = some_camera();
    CameraState close = open;
    close.position += Vec3(0.02, 0.01, -0.005);
    close.target += Vec3(0.05, 0, 0.01);
    close.roll = 0.05;
    close.vertical_fov = 0.58;
    const ThinLensCamera moving(open, close, kWidth, kHeight, 0, PixelFilter::box, 1);
    const ThinLensCamera at_open = static_camera(open);
    const ThinLensCamera at_close = static_camera(close);
    test::TestRandom random(6);
    for (int i = 0; i < 500; ++i) {
        CameraSample sample = random_sample(random);
        for (const bool end : {false, true}) {
            sample.time = end ? 0x1.fffffep-1f : 0.f;
            const Ray a = moving.ray(i, i % kHeight, sample);
            const Ray b = (end ? at_close : at_open).ray(i, i % kHeight, sample);
            ASSERT_NEAR((a.origin - b.origin).length(), 0, 1e-6);
            ASSERT_NEAR((a.direction - b.direction).length(), 0, 1e-6);
        }
    }
}

TEST(ThinLensCamera, MovingCamera_FrameStaysOrthonormalAndAimed) {
    const CameraState open = some_camera();
    CameraState close = open;
    close.position = Vec3(1.5, -2, 0.5);
    close.up = Vec3(0.2, 0, 1);
    close.roll = -0.8;
    const ThinLensCamera camera(open, close, kWidth, kHeight, 0, PixelFilter::box, 1);
    for (int i = 0; i <= 50; ++i) {
        const float time = static_cast<float>(i) / 50;
        const CameraFrame frame = camera.frame_at(time);
        ASSERT_NEAR(frame.right.length(), 1, 1e-6);
        ASSERT_NEAR(frame.up.length(), 1, 1e-6);
        ASSERT_NEAR(frame.right.dot(frame.up), 0, 1e-6);
        ASSERT_NEAR((frame.right.cross(frame.up) + frame.forward).length(), 0, 2e-6);
        const V2f target = *camera.project(V3f(open.target), time);
        ASSERT_NEAR((target - V2f(320, 180)).length(), 0, 1e-2);
    }
}

TEST(ThinLensCamera, Roll_TurnsThePictureClockwise) {
    CameraState state = some_camera();
    state.roll = 0.1;
    const ThinLensCamera camera = static_camera(state);
    const V2f above = *camera.project(V3f(state.target + Vec3(0, 0, 0.1)), 0);
    EXPECT_GT(above.x, 320);
    EXPECT_LT(above.y, 180);
}

TEST(ThinLensCamera, RayTimes_FollowTheTrapezoid) {
    const CameraState state = some_camera();
    const ThinLensCamera camera(state, state, kWidth, kHeight, 0.4, PixelFilter::box, 1);
    test::TestRandom random(7);
    const int samples = 100'000;
    std::vector<double> observed(40, 0.0);
    std::vector<double> expected(40, 0.0);
    for (int i = 0; i < samples; ++i) {
        const float time = camera.ray(3, 4, random_sample(random)).time;
        ASSERT_GE(time, 0);
        ASSERT_LT(time, 1);
        observed[static_cast<std::size_t>(time * 40)] += 1;
    }
    for (int b = 0; b < 40; ++b) {
        for (int k = 0; k < 16; ++k) {
            const float x = (static_cast<float>(b) + (static_cast<float>(k) + 0.5f) / 16) / 40;
            expected[static_cast<std::size_t>(b)] +=
                samples * static_cast<double>(pdf_trapezoid(x, 0.4f)) / (40 * 16);
        }
    }
    EXPECT_GT(test::chi_square_p_value(observed, expected), 1e-3);
}

TEST(ThinLensCamera, Filter_SpreadsRaysAroundThePixelsCentre) {
    const ThinLensCamera camera = static_camera(some_camera(), PixelFilter::blackman_harris, 3);
    test::TestRandom random(8);
    double mean = 0;
    float farthest = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Ray ray = camera.ray(100, 200, random_sample(random));
        const V2f pixel = *camera.project(ray.origin + ray.direction, 0);
        mean += static_cast<double>(pixel.x - 100.5f) / 20'000;
        farthest = std::max({farthest, std::abs(pixel.x - 100.5f), std::abs(pixel.y - 200.5f)});
    }
    EXPECT_NEAR(mean, 0, 0.02);
    EXPECT_GT(farthest, 0.9f);
    EXPECT_LE(farthest, 1.502f);
}

TEST(ThinLensCamera, PixelSolidAngles_SumToThePicture) {
    // Solid angle of a rectangle at distance 1 with half sides a, b: 4 atan(a b / sqrt(1+a^2+b^2)).
    CameraState state = some_camera();
    state.vertical_fov = 0.02;  // all pixels have nearly the same solid angle
    const ThinLensCamera camera = static_camera(state);
    const double b = std::tan(0.01);
    const double a = b * kWidth / kHeight;
    EXPECT_NEAR(static_cast<double>(camera.pixel_solid_angle()) * kWidth * kHeight,
                4 * std::atan(a * b / std::sqrt(1 + a * a + b * b)), 1e-3 * a * b);
}

std::string message(const CameraState& state) {
    try {
        const ThinLensCamera camera = static_camera(state);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(ThinLensCamera, UnusableStates_AreRefused) {
    CameraState state = some_camera();
    state.target = state.position;
    EXPECT_EQ(message(state), "camera: position and target are the same point");
    state = some_camera();
    state.up = state.position - state.target;
    EXPECT_EQ(message(state), "camera: 'up' is parallel to the direction of view");
    state = some_camera();
    state.vertical_fov = 4;
    EXPECT_EQ(message(state),
              "camera: the vertical field of view must lie between 0 and 180 degrees");
    state = some_camera();
    state.focus_distance = 0;
    EXPECT_EQ(message(state), "camera: the focus distance must be greater than 0");
    state = some_camera();
    state.lens_radius = -1e-9;
    EXPECT_EQ(message(state), "camera: the lens radius must not be negative");
    state = some_camera();
    state.blades = 2;
    EXPECT_EQ(message(state), "camera: the number of lens blades must be 0 or at least 3");
    state = some_camera();
    state.roll = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(message(state), "camera: a value is not a finite number");
}

TEST(ThinLensCamera, Arrival_UndoesRay) {
    CameraState open = some_camera();
    CameraState close = open;
    close.position += Vec3(0.1, 0.05, 0);
    close.roll = 0.1;
    test::TestRandom random(21);
    for (const double lens_radius : {0.0, 0.02}) {
        open.lens_radius = lens_radius;
        close.lens_radius = lens_radius;
        const ThinLensCamera camera(open, close, kWidth, kHeight, 0.3, PixelFilter::box, 1);
        for (int i = 0; i < 1'000; ++i) {
            const CameraSample sample = random_sample(random);
            const int x = i % kWidth;
            const int y = (7 * i) % kHeight;
            const Ray ray = camera.ray(x, y, sample);
            const ThinLensCamera::Aperture aperture = camera.aperture(sample);
            EXPECT_EQ(aperture.time, ray.time);
            EXPECT_EQ(aperture.position, ray.origin);
            const auto arrival = camera.image_point(aperture, ray.direction);
            ASSERT_TRUE(arrival);
            EXPECT_NEAR(arrival->position.x, static_cast<float>(x) + sample.pixel.x, 2e-3f);
            EXPECT_NEAR(arrival->position.y, static_cast<float>(y) + sample.pixel.y, 2e-3f);
            EXPECT_FALSE(camera.image_point(aperture, -ray.direction));
        }
    }
}

TEST(ThinLensCamera, PixelSolidAngle_IsThatBetweenItsCorners) {
    CameraState state = some_camera();
    state.lens_radius = 0.05;
    const ThinLensCamera camera = static_camera(state);
    CameraSample sample = centre();
    sample.lens = V2f(0.9f, 0.2f);
    const ThinLensCamera::Aperture aperture = camera.aperture(sample);
    for (const int x : {0, 320, 639}) {
        // Over three neighbouring pixels along each side, because one pixel is too small for float.
        const auto toward = [&](int dx, int dy) {
            return camera.ray(x + dx, 40 + dy, sample).direction;
        };
        const V3f middle = toward(0, 0);
        const V3f across = (toward(3, 0) - toward(-3, 0)) / 6;
        const V3f down = (toward(0, 3) - toward(0, -3)) / 6;
        const double solid_angle = static_cast<double>(across.cross(down).length());
        EXPECT_NEAR(static_cast<double>(camera.image_point(aperture, middle)->pixel_solid_angle),
                    solid_angle, 1e-3 * solid_angle)
            << x;
    }
}

}  // namespace
}  // namespace carom::render
