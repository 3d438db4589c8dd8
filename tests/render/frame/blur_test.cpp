// Blur has closed forms: how long an object covers a pixel, and the size of the circle of
// confusion.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/render/scene_builder.h"
#include "tests/render/two_disks.h"

namespace carom::render {
namespace {

using test::camera;
using test::pixel;
using test::SceneBuilder;
using test::small_settings;
using test::static_frame;

constexpr double kDistance = 400;  // m: far enough for the projection to be practically parallel
constexpr double kPixel = 0.05;    // m at that distance
constexpr int kWidth = 64;
constexpr int kHeight = 32;

CameraState far_camera() {
    return camera(Vec3(0, -kDistance, 0), Vec3(0, 0, 0),
                  2 * std::atan(0.5 * kHeight * kPixel / kDistance));
}

double x_of(int column) {
    return (column + 0.5 - kWidth / 2) * kPixel;
}
double z_of(int row) {
    return (kHeight / 2 - row - 0.5) * kPixel;
}

SceneBuilder one_ball(double radius) {
    SceneBuilder builder;
    builder.diffuse("skin", 0.5).environment(1);
    builder.sphere("ball", radius, Vec3(0, 0, 0), "skin", "ball");
    return builder;
}

Film render_ball(double radius, const sim::Track& track, double open, double close, int samples) {
    const SceneBuilder builder = one_ball(radius);
    const RenderSettings settings = small_settings(kWidth, kHeight, samples);
    FrameInput frame = static_frame(far_camera());
    frame.scene_open = open;
    frame.scene_close = close;
    const std::vector<sim::Track> tracks{track};
    return render_frame(PreparedScene(builder.scene, settings), tracks, frame, settings);
}

TEST(MotionBlur, DiscCrossingThePicture_CoversEachPixelForItsFractionOfTheShutter) {
    // In the middle of its path the disc covers a point at height z while it moves by a chord's
    // length, 2 sqrt(r^2 - z^2).
    const double radius = 0.4;
    const double distance = 2.0;
    const Film film = render_ball(
        radius, test::straight_track("ball", Vec3(-1, 0, 0), Vec3(1, 0, 0), 0, 1), 0, 1, 1024);
    for (int row = 0; row < kHeight; ++row) {
        const double z = z_of(row);
        if (std::abs(std::abs(z) - radius) < kPixel) {
            continue;  // the edge of the streak cuts the pixel
        }
        const double chord = std::abs(z) < radius ? 2 * std::sqrt(radius * radius - z * z) : 0;
        for (const int column : {28, 32, 36}) {
            EXPECT_NEAR(pixel(film, column, row, 3), chord / distance, 0.012)
                << "column " << column << ", row " << row;
        }
    }
}

TEST(MotionBlur, ImpactInsideTheShutter_LeavesACorner) {
    // To x = 0.5 and straight back: nothing beyond, and before that the fraction of the time in
    // which the disc's edge is farther to the right.
    const double radius = 0.3;
    sim::Key start;
    start.time = 0;
    start.position = Vec3(-0.5, 0, 0);
    start.velocity_in = start.velocity_out = Vec3(2, 0, 0);
    sim::Key impact = start;
    impact.time = 0.5;
    impact.position = Vec3(0.5, 0, 0);
    impact.velocity_out = Vec3(-2, 0, 0);
    sim::Key end = start;
    end.time = 1;
    end.velocity_in = end.velocity_out = Vec3(-2, 0, 0);
    const Film film = render_ball(radius, sim::Track("ball", {start, impact, end}), 0, 1, 1024);
    const int row = kHeight / 2;
    const double height = z_of(row);
    const double half_chord = std::sqrt(radius * radius - height * height);
    for (int column = 0; column < kWidth; ++column) {
        const double x = x_of(column);
        if (x > 0.5 + half_chord + kPixel) {
            EXPECT_EQ(pixel(film, column, row, 3), 0) << column;
        } else if (x > 0.5 - half_chord + kPixel && x < 0.5 + half_chord - kPixel) {
            // The right edge passes x twice: for 2 (0.5 + chord - x) of a path of 2.
            EXPECT_NEAR(pixel(film, column, row, 3), 0.5 + half_chord - x, 0.01) << column;
        }
    }
}

TEST(MotionBlur, ZeroShutter_EqualsTheStandingBallExactly) {
    const Film sharp = render_ball(0.4, test::resting_track("ball", Vec3(0.1, 0, 0)), 0, 0, 16);
    const Film opened = render_ball(0.4, test::resting_track("ball", Vec3(0.1, 0, 0)), 0, 1, 16);
    const Film passing = render_ball(
        0.4, test::straight_track("ball", Vec3(0.1, 0, 0), Vec3(1.1, 0, 0), 0, 1), 0, 0, 16);
    EXPECT_EQ(sharp.rgba, opened.rgba);
    EXPECT_EQ(sharp.rgba, passing.rgba);
}

TEST(DepthOfField, ZeroAperture_EqualsThePinholeExactlyWhereverItIsFocused) {
    const SceneBuilder builder = one_ball(0.4);
    const RenderSettings settings = small_settings(kWidth, kHeight, 8);
    const PreparedScene scene(builder.scene, settings);
    const std::vector<sim::Track> tracks{test::resting_track("ball", Vec3(0, 0, 0))};
    FrameInput frame = static_frame(far_camera());
    const Film pinhole = render_frame(scene, tracks, frame, settings);
    frame.camera_open.focus_distance = frame.camera_close.focus_distance = 3;
    frame.camera_open.blades = frame.camera_close.blades = 6;
    EXPECT_EQ(render_frame(scene, tracks, frame, settings).rgba, pinhole.rgba);
}

// In an even light the picture shows how much of the pupil each of its places has.
TEST(DepthOfField, CatEye_DarkensByTheAreaThatIsCovered) {
    SceneBuilder builder;
    builder.environment(1);
    RenderSettings settings = small_settings(kWidth, kHeight, 256);
    settings.for_denoiser = true;
    CameraState state = far_camera();
    state.lens_radius = 1;
    state.lens = LensShape{.cat_eye_ratio = 1.1, .cat_eye_shift = 0.9};
    const Film film =
        render_frame(PreparedScene(builder.scene, settings), {}, static_frame(state), settings);
    const double corner = 0.5 * std::hypot(kWidth, kHeight);
    for (const int column : {0, 10, kWidth / 2}) {
        const double far = std::hypot(column + 0.5 - kWidth / 2, 0.5 - kHeight / 2) / corner;
        EXPECT_NEAR(pixel(film, column, 0, 1), test::common_area(1.1, 0.9 * far) / std::numbers::pi,
                    4e-3)
            << column;
    }
    EXPECT_EQ(pixel(film, kWidth / 2, kHeight / 2, 1), 1);
}

TEST(DepthOfField, SmallSpotOutOfFocus_SpreadsOverTheCircleOfConfusion) {
    // A point at distance d, focus at f, lens radius a: a spot of radius a |d - f| / f at d.
    SceneBuilder builder;
    builder.diffuse("skin", 0.5).environment(1).sphere("ball", 0.02, Vec3(0, 0, 0), "skin");
    const RenderSettings settings = small_settings(kWidth, kHeight, 1024);
    CameraState state = far_camera();
    state.focus_distance = 2 * kDistance;
    state.lens_radius = 1.2;  // spot radius 0.6
    const Film film =
        render_frame(PreparedScene(builder.scene, settings), {}, static_frame(state), settings);
    const double spot = 0.6;
    double inside = 0;
    for (int row = 0; row < kHeight; ++row) {
        for (int column = 0; column < kWidth; ++column) {
            const double r = std::hypot(x_of(column), z_of(row));
            if (r > spot + 0.02 + kPixel) {
                EXPECT_EQ(pixel(film, column, row, 3), 0) << column << " " << row;
            }
            inside += pixel(film, column, row, 3);
        }
    }
    // The ball's area, in pixels, is spread and not lost.
    const double area = std::numbers::pi * 0.02 * 0.02 / (kPixel * kPixel);
    EXPECT_NEAR(inside, area, 0.05 * area);
}

}  // namespace
}  // namespace carom::render
