#include "render/integrator/direct_light.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/render/integrator/integrator_scene.h"

namespace carom::render {
namespace {

using test::Estimate;
using test::SceneBuilder;

/// Balls of every kind of lobe on a floor, two area lights.
SceneBuilder balls_on_floor() {
    SceneBuilder builder;
    StandardMaterial lacquer;
    lacquer.base = Vec3(0.6, 0.3, 0.2);
    lacquer.coat = {1, 1.5, 0.5};
    StandardMaterial metal;
    metal.base = Vec3(0.9, 0.7, 0.4);
    metal.metal = 1;
    metal.roughness = 0.55;
    StandardMaterial cloth;
    cloth.base = Vec3(0.2, 0.5, 0.3);
    cloth.sheen = 0.5;
    cloth.specular = 0.5;
    cloth.roughness = 0.7;
    builder.material("lacquer", lacquer).material("metal", metal).material("cloth", cloth);
    builder.object("floor", PlaneShape{}, Vec3(0, 0, 0), "cloth");
    builder.sphere("a", 0.3, Vec3(-0.3, 0, 0.3), "lacquer");
    builder.sphere("b", 0.25, Vec3(0.3, 0.1, 0.25), "metal");
    builder.lamp(Vec3(0, 0, 1.4), 0.6, 0.5, 6).bulb(Vec3(0.9, -0.4, 0.8), 0.25, 8);
    builder.environment(0.05);
    return builder;
}

Estimate with(DirectStrategy strategy, int bounces) {
    PathSettings path;
    path.strategy = strategy;
    path.max_bounces = bounces;
    return test::picture_luminance(balls_on_floor().scene,
                                   test::camera(Vec3(0, -2.2, 1), Vec3(0, 0, 0.25), 0.6), path, 24,
                                   16);
}

TEST(DirectLight, EveryStrategy_HasTheSameMean) {
    for (const int bounces : {0, 2}) {
        const Estimate both = with(DirectStrategy::both, bounces);
        const Estimate lights = with(DirectStrategy::lights_only, bounces);
        const Estimate scattering = with(DirectStrategy::scattering_only, bounces);
        EXPECT_NEAR(lights.mean, both.mean, 4 * std::hypot(lights.error, both.error)) << bounces;
        EXPECT_NEAR(scattering.mean, both.mean, 4 * std::hypot(scattering.error, both.error))
            << bounces;
        EXPECT_LT(both.error, 0.01 * both.mean);
        EXPECT_LT(scattering.error, 0.02 * both.mean);
    }
}

TEST(DirectLight, Together_TheyBeatEitherAlone) {
    const Estimate both = with(DirectStrategy::both, 0);
    EXPECT_LT(both.error, 1.1 * with(DirectStrategy::lights_only, 0).error);
    EXPECT_LT(both.error, with(DirectStrategy::scattering_only, 0).error);
}

TEST(PowerHeuristic, TheTwoShares_AddUpToOne) {
    EXPECT_FLOAT_EQ(power_heuristic(2, 3) + power_heuristic(3, 2), 1);
    EXPECT_EQ(power_heuristic(1, 0), 1);
    EXPECT_LT(power_heuristic(1e-20f, 1e20f), 1e-6f);
}

}  // namespace
}  // namespace carom::render
