// Scenes with known light everywhere (furnace tests).
#include <numbers>

#include <gtest/gtest.h>

#include "tests/render/scene_builder.h"

namespace carom::render {
namespace {

using test::camera;
using test::SceneBuilder;
using test::small_settings;
using test::static_frame;

/// Radiance of the wall of a diffuse hollow sphere (radius 1) with a small black lamp of radius r
/// at its centre, after at most `bounces` reflections from wall to wall. The lamp gives the wall
/// the irradiance pi L r^2; of the wall's own light the fraction r^2 hits the lamp.
double hollow_sphere_radiance(double albedo, double lamp_radius, double radiance, int bounces) {
    const double fraction = lamp_radius * lamp_radius;
    double sum = 0;
    double term = albedo * radiance * fraction;
    for (int bounce = 0; bounce <= bounces; ++bounce) {
        sum += term;
        term *= albedo * (1 - fraction);
    }
    return sum;
}

double rendered_hollow_sphere(double albedo, int bounces, int samples) {
    SceneBuilder builder;
    builder.diffuse("wall", albedo).sphere("wall", 1, Vec3(0, 0, 0), "wall");
    builder.bulb(Vec3(0, 0, 0), 0.1, 100);
    RenderSettings settings = small_settings(32, 32, samples);
    settings.max_bounces = bounces;
    // Looking past the lamp at the wall.
    const FrameInput frame = static_frame(camera(Vec3(0, -0.5, 0.3), Vec3(0, -0.9, 0.9), 0.6));
    return test::mean_red(
        render_frame(PreparedScene(builder.scene, settings), {}, frame, settings));
}

TEST(HollowSphere, LimitedBounces_SumTheGeometricSeries) {
    for (const int bounces : {0, 1, 4}) {
        const double exact = hollow_sphere_radiance(0.8, 0.1, 100, bounces);
        EXPECT_NEAR(rendered_hollow_sphere(0.8, bounces, 16), exact, 0.005 * exact) << bounces;
    }
}

TEST(HollowSphere, LongPathsUnderRoulette_ReachTheLimit) {
    const double limit = hollow_sphere_radiance(0.8, 0.1, 100, 1000);
    EXPECT_NEAR(rendered_hollow_sphere(0.8, 64, 16), limit, 0.01 * limit);
}

struct Look {
    const char* name;
    StandardMaterial material;
};

StandardMaterial white() {
    StandardMaterial material;
    material.base = Vec3(1, 1, 1);
    return material;
}

/// A ball in a room with radiance 1 everywhere.
Film ball_in_furnace(const StandardMaterial& material, bool moving, double lens_radius,
                     int bounces = 4, int samples = 64) {
    SceneBuilder builder;
    builder.material("skin", material).environment(1);
    builder.sphere("ball", 0.5, Vec3(0, 0, 0), "skin", "ball");
    RenderSettings settings = small_settings(24, 24, samples);
    settings.max_bounces = bounces;
    CameraState state = camera(Vec3(0, -3, 0), Vec3(0, 0, 0), 0.45);
    state.lens_radius = lens_radius;
    FrameInput frame = static_frame(state);
    frame.scene_close = 0.02;
    const std::vector<sim::Track> tracks{
        moving ? test::straight_track("ball", Vec3(-0.3, 0, 0), Vec3(0.3, 0, 0), 0, 0.02)
               : test::resting_track("ball", Vec3(0, 0, 0))};
    return render_frame(PreparedScene(builder.scene, settings), tracks, frame, settings);
}

TEST(Furnace, WhiteBallUnderASmoothCoat_CannotBeSeen) {
    // F + (1 - F) 1 = 1 at every angle, also in motion and out of focus.
    StandardMaterial coated = white();
    coated.coat.weight = 1;
    for (const bool moving : {false, true}) {
        for (const double lens_radius : {0.0, 0.2}) {
            const Film film = ball_in_furnace(coated, moving, lens_radius);
            for (std::size_t i = 0; i < film.rgba.size(); i += 4) {
                ASSERT_NEAR(film.rgba[i], 1, 2e-5f) << "moving " << moving;
            }
        }
    }
}

TEST(Furnace, ClearGlassBall_CannotBeSeen) {
    StandardMaterial glass = white();
    glass.transmission = 1;
    glass.roughness = 0;
    // Paths that total reflection keeps inside end after four bounces without light: (1 - F) F^4 is
    // missing.
    for (const bool moving : {false, true}) {
        const Film film = ball_in_furnace(glass, moving, 0);
        EXPECT_NEAR(test::mean_red(film), 1, 1e-3) << "moving " << moving;
    }
}

TEST(Furnace, FrostedGlassBall_CannotBeSeen) {
    StandardMaterial glass = white();
    glass.transmission = 1;
    for (const double roughness : {0.3, 0.6}) {
        glass.roughness = roughness;
        const double mean = test::mean_red(ball_in_furnace(glass, false, 0, 40));
        EXPECT_LT(mean, 1.003) << roughness;
        EXPECT_GT(mean, 0.99) << roughness;
    }
}

// Light that is within the glass after a path's last bounce still comes out.
TEST(Furnace, GlassBalls_CannotBeSeenWithFewBouncesEither) {
    StandardMaterial glass = white();
    glass.transmission = 1;
    for (const double roughness : {0.0, 0.5}) {
        glass.roughness = roughness;
        for (const int bounces : {1, 4}) {
            const double mean = test::mean_red(ball_in_furnace(glass, false, 0, bounces, 256));
            EXPECT_NEAR(mean, 1, 0.01) << roughness << ", bounces " << bounces;
        }
    }
}

// Highlights, gloss and frosting of phong surfaces whose albedos add up to 1.
TEST(Furnace, WhitePhongBalls_CannotBeSeen) {
    PhongMaterial shiny, glossy, frosted;
    shiny.diffuse = Vec3(0.6, 0.6, 0.6);
    shiny.specular = Vec3(0.4, 0.4, 0.4);
    shiny.shininess = 20;
    glossy.diffuse = Vec3(0.2, 0.2, 0.2);
    glossy.reflectance = Vec3(0.8, 0.8, 0.8);
    glossy.reflectance_spread = 0.3;
    frosted.diffuse = Vec3(0, 0, 0);
    frosted.transmittance = Vec3(0.9, 0.9, 0.9);
    frosted.transmittance_spread = 0.3;
    frosted.reflectance = Vec3(0.1, 0.1, 0.1);
    frosted.reflectance_spread = 0.2;
    frosted.index = 1.5;
    for (const PhongMaterial& material : {shiny, glossy, frosted}) {
        SceneBuilder builder;
        builder.phong("skin", material).environment(1);
        builder.sphere("ball", 0.5, Vec3(0, 0, 0), "skin");
        RenderSettings settings = small_settings(24, 24, 1024);
        settings.max_bounces = 4;
        const FrameInput frame = static_frame(camera(Vec3(0, -3, 0), Vec3(0, 0, 0), 0.3));
        const double mean = test::mean_red(
            render_frame(PreparedScene(builder.scene, settings), {}, frame, settings));
        EXPECT_NEAR(mean, 1, 0.005);
    }
}

TEST(Furnace, GlassBoxWithColourInDepth_DimsByBeerAndLambert) {
    // Straight through a slab of 0.2 m: (1 - F)^2 / (1 - F^2 a^2) a + reflections from both sides.
    StandardMaterial glass = white();
    glass.transmission = 1;
    glass.roughness = 0;
    glass.transmission_colour = Vec3(0.5, 0.5, 0.5);
    glass.transmission_depth = 0.1;
    SceneBuilder builder;
    builder.material("glass", glass).environment(1);
    builder.object("slab", BoxShape{Vec3(4, 0.2, 4)}, Vec3(0, 0, 0), "glass");
    RenderSettings settings = small_settings(16, 16, 1024);
    settings.max_bounces = 12;
    const FrameInput frame = static_frame(camera(Vec3(0, -3, 0), Vec3(0, 0, 0), 0.02));
    const double mean =
        test::mean_red(render_frame(PreparedScene(builder.scene, settings), {}, frame, settings));
    constexpr double kF = 0.04;
    constexpr double kA = 0.25;  // after 0.2 m
    const double rest = 1 - kF * kF * kA * kA;
    const double through = (1 - kF) * (1 - kF) * kA / rest;
    const double back = kF + (1 - kF) * (1 - kF) * kF * kA * kA / rest;
    EXPECT_NEAR(mean, through + back, 2e-3);
}

TEST(Furnace, GreyDiffuseBall_ShowsItsAlbedoMovingAndOutOfFocus) {
    StandardMaterial grey = white();
    grey.base = Vec3(0.6, 0.6, 0.6);
    for (const bool moving : {false, true}) {
        for (const double lens_radius : {0.0, 0.2}) {
            const Film film = ball_in_furnace(grey, moving, lens_radius);
            for (std::size_t i = 0; i < film.rgba.size(); i += 4) {
                const float coverage = film.rgba[i + 3];
                ASSERT_NEAR(film.rgba[i], 0.6f * coverage + (1 - coverage), 2e-5f);
            }
        }
    }
}

TEST(Furnace, EveryMaterial_GivesOffAtMostWhatItGets) {
    StandardMaterial metal = white();
    metal.metal = 1;
    metal.roughness = 0.7;
    StandardMaterial plastic = white();
    plastic.specular = 1;
    StandardMaterial cloth = white();
    cloth.sheen = 1;
    StandardMaterial lacquer = white();
    lacquer.coat = {1, 1.5, 0.4};
    for (const Look& look : {Look{"metal", metal}, Look{"plastic", plastic}, Look{"cloth", cloth},
                             Look{"lacquer", lacquer}}) {
        const Film film = ball_in_furnace(look.material, false, 0);
        const double mean = test::mean_red(film);
        EXPECT_LT(mean, 1.002) << look.name;
        EXPECT_GT(mean, 0.95) << look.name;
    }
}

}  // namespace
}  // namespace carom::render
