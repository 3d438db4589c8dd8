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

Vec3 rendered_hollow_sphere(const Vec3& albedo, int bounces, int samples) {
    SceneBuilder builder;
    StandardMaterial wall;
    wall.base = albedo;
    builder.material("wall", wall).sphere("wall", 1, Vec3(0, 0, 0), "wall");
    builder.bulb(Vec3(0, 0, 0), 0.1, 100);
    RenderSettings settings = small_settings(32, 32, samples);
    settings.max_bounces = bounces;
    // Looking past the lamp at the wall.
    const FrameInput frame = static_frame(camera(Vec3(0, -0.5, 0.3), Vec3(0, -0.9, 0.9), 0.6));
    return test::mean_colour(
        render_frame(PreparedScene(builder.scene, settings), {}, frame, settings));
}

TEST(HollowSphere, LimitedBounces_SumTheGeometricSeries) {
    const Vec3 albedo(0.8, 0.5, 0.3);
    for (const int bounces : {0, 1, 4}) {
        const Vec3 found = rendered_hollow_sphere(albedo, bounces, 16);
        for (int c = 0; c < 3; ++c) {
            const double exact = hollow_sphere_radiance(albedo[c], 0.1, 100, bounces);
            EXPECT_NEAR(found[c], exact, 0.005 * exact) << bounces << ", channel " << c;
        }
    }
}

TEST(HollowSphere, LongPathsUnderRoulette_ReachTheLimit) {
    const Vec3 albedo(0.8, 0.6, 0.4);
    const Vec3 found = rendered_hollow_sphere(albedo, 64, 16);
    for (int c = 0; c < 3; ++c) {
        const double limit = hollow_sphere_radiance(albedo[c], 0.1, 100, 1000);
        EXPECT_NEAR(found[c], limit, 0.01 * limit) << c;
    }
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
            for (std::size_t i = 0; i < film.rgba.size(); ++i) {
                if (i % 4 < 3) {
                    ASSERT_NEAR(film.rgba[i], 1, 2e-5f) << "moving " << moving;
                }
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
        const auto [least, most] = test::range_of_means(film);
        EXPECT_NEAR(least, 1, 1e-3) << "moving " << moving;
        EXPECT_NEAR(most, 1, 1e-3) << "moving " << moving;
    }
}

TEST(Furnace, FrostedGlassBall_CannotBeSeen) {
    StandardMaterial glass = white();
    glass.transmission = 1;
    for (const double roughness : {0.3, 0.6}) {
        glass.roughness = roughness;
        const auto [least, most] = test::range_of_means(ball_in_furnace(glass, false, 0, 40));
        EXPECT_LT(most, 1.003) << roughness;
        EXPECT_GT(least, 0.99) << roughness;
    }
}

// Light that is within the glass after a path's last bounce still comes out.
TEST(Furnace, GlassBalls_CannotBeSeenWithFewBouncesEither) {
    StandardMaterial glass = white();
    glass.transmission = 1;
    for (const double roughness : {0.0, 0.5}) {
        glass.roughness = roughness;
        for (const int bounces : {1, 4}) {
            const auto [least, most] =
                test::range_of_means(ball_in_furnace(glass, false, 0, bounces, 256));
            EXPECT_NEAR(least, 1, 0.01) << roughness << ", bounces " << bounces;
            EXPECT_NEAR(most, 1, 0.01) << roughness << ", bounces " << bounces;
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
        const auto [least, most] = test::range_of_means(
            render_frame(PreparedScene(builder.scene, settings), {}, frame, settings));
        EXPECT_NEAR(least, 1, 0.005);
        EXPECT_NEAR(most, 1, 0.005);
    }
}

TEST(Furnace, GlassBoxWithColourInDepth_DimsByBeerAndLambert) {
    // Straight through a slab of 0.2 m: (1 - F)^2 / (1 - F^2 a^2) a + reflections from both sides.
    StandardMaterial glass = white();
    glass.transmission = 1;
    glass.roughness = 0;
    glass.transmission_colour = Vec3(0.5, 0.7, 0.9);
    glass.transmission_depth = 0.1;
    SceneBuilder builder;
    builder.material("glass", glass).environment(1);
    builder.object("slab", BoxShape{Vec3(4, 0.2, 4)}, Vec3(0, 0, 0), "glass");
    RenderSettings settings = small_settings(16, 16, 1024);
    settings.max_bounces = 12;
    const FrameInput frame = static_frame(camera(Vec3(0, -3, 0), Vec3(0, 0, 0), 0.02));
    const Vec3 mean = test::mean_colour(
        render_frame(PreparedScene(builder.scene, settings), {}, frame, settings));
    for (int c = 0; c < 3; ++c) {
        constexpr double kF = 0.04;
        const double a = glass.transmission_colour[c] * glass.transmission_colour[c];  // in 0.2 m
        const double rest = 1 - kF * kF * a * a;
        const double through = (1 - kF) * (1 - kF) * a / rest;
        const double back = kF + (1 - kF) * (1 - kF) * kF * a * a / rest;
        EXPECT_NEAR(mean[c], through + back, 2e-3) << c;
    }
}

TEST(Furnace, DiffuseBall_ShowsItsAlbedoMovingAndOutOfFocus) {
    const Vec3 albedo(0.6, 0.4, 0.1);
    StandardMaterial coloured = white();
    coloured.base = albedo;
    for (const bool moving : {false, true}) {
        for (const double lens_radius : {0.0, 0.2}) {
            const Film film = ball_in_furnace(coloured, moving, lens_radius);
            for (std::size_t i = 0; i < film.rgba.size(); ++i) {
                if (i % 4 == 3) {
                    continue;
                }
                const float coverage = film.rgba[i - i % 4 + 3];
                const auto own = static_cast<float>(albedo[static_cast<int>(i % 4)]);
                ASSERT_NEAR(film.rgba[i], own * coverage + (1 - coverage), 2e-5f);
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
        const auto [least, most] = test::range_of_means(film);
        EXPECT_LT(most, 1.002) << look.name;
        EXPECT_GT(least, 0.95) << look.name;
    }
}

}  // namespace
}  // namespace carom::render
