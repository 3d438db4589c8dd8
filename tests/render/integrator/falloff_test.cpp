// Lamps without falloff, in both integrators, against closed forms.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/render/integrator/distributed_scene.h"
#include "tests/render/integrator/integrator_scene.h"

namespace carom::render {
namespace {

using test::DistributedScene;
using test::SceneBuilder;

constexpr double kAlbedo = 0.6;
constexpr double kRadiance = 2;

SceneDescription floor_under(const LightDescription& light) {
    SceneBuilder builder;
    builder.diffuse("floor", kAlbedo).object("floor", PlaneShape{}, Vec3(0), "floor");
    builder.scene.lights.push_back(light);
    return builder.scene;
}

LightDescription square_lamp(double height, double half) {
    return {"lamp", RectangleLight{{0, 0, height},
                                   {half, 0, 0},
                                   {0, half, 0},
                                   {0, 0, -1},
                                   Vec3(kRadiance),
                                   Falloff::none}};
}

LightDescription bulb(double height, double radius) {
    return {"bulb", SphereLight{{0, 0, height}, radius, Vec3(kRadiance), Falloff::none}};
}

/// A small part of the floor at the origin, seen obliquely past the lamp.
test::Estimate floor_by_paths(const SceneDescription& scene, DirectStrategy strategy, int samples) {
    PathSettings path;
    path.max_bounces = 1;
    path.strategy = strategy;
    return test::picture_luminance(scene, test::camera(Vec3(0, -1, 0.2), Vec3(0, 0, 0), 0.002),
                                   path, 8, samples);
}

TEST(Falloff, None_LightsTheFloorTheSameFromEveryHeight) {
    for (const double height : {1.0, 4.0, 20.0}) {
        for (const LightDescription& light : {square_lamp(height, 0.05), bulb(height, 0.05)}) {
            const SceneDescription scene = floor_under(light);
            // The irradiance is pi L, except for the corners of the lamp, which are seen at a
            // slight angle.
            const double exact = kAlbedo * kRadiance;
            EXPECT_NEAR(floor_by_paths(scene, DirectStrategy::both, 16).mean, exact, 3e-3 * exact)
                << light.name << " at " << height;
            DistributedSettings settings = test::whitted(0);
            const auto seen =
                DistributedScene(scene).trace(settings, Vec3(0, -1, 0.2), Vec3(0, 1, -0.2));
            EXPECT_NEAR(seen.sample.radiance.y, exact, 3e-3 * exact)
                << light.name << " at " << height;
        }
    }
}

// By light sampling, by chance, or both: the same light.
TEST(Falloff, None_IsTheSameForEveryStrategy) {
    for (const LightDescription& light : {square_lamp(0.7, 0.5), bulb(0.8, 0.4)}) {
        const SceneDescription scene = floor_under(light);
        const auto exact = floor_by_paths(scene, DirectStrategy::lights_only, 256);
        for (const DirectStrategy strategy :
             {DirectStrategy::both, DirectStrategy::scattering_only}) {
            const auto other = floor_by_paths(scene, strategy, 256);
            EXPECT_NEAR(other.mean, exact.mean, 5 * std::hypot(other.error, exact.error))
                << light.name;
            EXPECT_LT(other.error, 0.02 * other.mean) << light.name;
        }
    }
}

// A camera sees the lamp with the radiance in its description.
TEST(Falloff, None_LeavesTheLampAsItLooks) {
    for (const double height : {1.0, 4.0}) {
        const SceneDescription scene = floor_under(square_lamp(height, 0.05));
        const auto seen =
            DistributedScene(scene).trace(test::whitted(0), Vec3(0, 0, 0.1), Vec3(0, 0, 1));
        EXPECT_EQ(seen.sample.radiance, V3f(kRadiance));
        const test::Estimate paths = test::picture_luminance(
            scene, test::camera(Vec3(0, 0, 0.1), Vec3(0, 0.0001, height), 0.002), {}, 4, 1);
        EXPECT_NEAR(paths.mean, kRadiance, 1e-5);
    }
}

}  // namespace
}  // namespace carom::render
