// Delta lights in both integrators, against closed forms.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/render/integrator/distributed_scene.h"
#include "tests/render/integrator/integrator_scene.h"

namespace carom::render {
namespace {

using test::DistributedScene;
using test::SceneBuilder;
using test::whitted;

SceneBuilder floor_under(const LightDescription& light) {
    SceneBuilder builder;
    builder.diffuse("floor", 0.6).object("floor", PlaneShape{}, Vec3(0), "floor");
    builder.scene.lights.push_back(light);
    return builder;
}

/// A small part of the floor at the origin, seen obliquely from above.
test::Estimate floor_by_paths(const SceneDescription& scene, DirectStrategy strategy) {
    PathSettings path;
    path.max_bounces = 2;
    path.strategy = strategy;
    return test::picture_luminance(scene, test::camera(Vec3(0, -1, 1), Vec3(0, 0, 0), 0.002), path,
                                   8, 4);
}

double floor_by_whitted(const SceneDescription& scene) {
    return DistributedScene(scene)
        .trace(whitted(0), Vec3(0, -1, 1), Vec3(0, 1, -1))
        .sample.radiance.y;
}

struct Case {
    LightDescription light;
    double irradiance;  // of the floor at the origin
};

std::vector<Case> cases() {
    return {{{"point", PointLight{{0, 3, 4}, {50, 50, 50}}}, 50.0 / 25 * 0.8},
            {{"spot", SpotLight{{0, 3, 4}, {0, -3, -4}, {50, 50, 50}, 0.2, 0.3}}, 50.0 / 25 * 0.8},
            {{"spot beside", SpotLight{{0, 3, 4}, {0, 0, -4}, {50, 50, 50}, 0.2, 0.3}}, 0},
            {{"point without falloff", PointLight{{0, 3, 4}, {5, 5, 5}, Falloff::none}}, 5 * 0.8},
            {{"spot without falloff",
              SpotLight{{0, 3, 4}, {0, -3, -4}, {5, 5, 5}, 0.2, 0.3, Falloff::none}},
             5 * 0.8},
            {{"sun", DirectionalLight{{0, -3, -4}, {2, 2, 2}}}, 2 * 0.8}};
}

TEST(DeltaLights, OnADiffuseFloor_GiveTheirIrradianceInBothIntegrators) {
    for (const Case& c : cases()) {
        const SceneDescription scene = floor_under(c.light).scene;
        const double exact = c.irradiance * 0.6 / M_PI;
        const test::Estimate paths = floor_by_paths(scene, DirectStrategy::both);
        EXPECT_NEAR(paths.mean, exact, 1e-3 * exact + 1e-9) << c.light.name;
        EXPECT_LE(paths.error, 1e-3 * exact) << c.light.name;  // no noise except the pixel's own
        EXPECT_NEAR(floor_by_whitted(scene), exact, 1e-4 * exact + 1e-9) << c.light.name;
    }
}

TEST(DeltaLights, BehindABall_CastAHardShadow) {
    for (const Case& c : cases()) {
        SceneBuilder builder = floor_under(c.light);
        builder.diffuse("black", 0).sphere("ball", 0.3, Vec3(0, 1.5, 2), "black");
        EXPECT_NEAR(floor_by_whitted(builder.scene), 0, 1e-9) << c.light.name;
        EXPECT_NEAR(floor_by_paths(builder.scene, DirectStrategy::lights_only).mean, 0, 1e-6)
            << c.light.name;
    }
}

// Among other lights they are chosen in proportion to importance, and the sum stays the same.
TEST(DeltaLights, AmongOthers_AddUpAtEveryVertex) {
    SceneBuilder builder;
    builder.diffuse("white", 0.7);
    builder.object("floor", PlaneShape{}, Vec3(0), "white");
    builder.sphere("ball", 0.5, Vec3(0, 0.5, 0.5), "white").environment(0.1);
    builder.lamp(Vec3(1, 0, 2), 0.3, 0.3, 5);
    const auto mean = [&](const std::vector<LightDescription>& extra) {
        SceneDescription scene = builder.scene;
        scene.lights.insert(scene.lights.end(), extra.begin(), extra.end());
        PathSettings path;
        path.max_bounces = 3;
        return test::picture_luminance(scene, test::camera(Vec3(0, -2, 1), Vec3(0, 0, 0.4), 0.6),
                                       path, 16, 16);
    };
    const LightDescription point{"point", PointLight{{-1, -1, 1.5}, {2, 2, 2}}};
    const LightDescription sun{"sun", DirectionalLight{{0.3, 0.2, -1}, {0.8, 0.8, 0.8}}};
    const test::Estimate none = mean({});
    const test::Estimate first = mean({point});
    const test::Estimate second = mean({sun});
    const test::Estimate both = mean({point, sun});
    const double error =
        std::hypot(std::hypot(none.error, first.error), std::hypot(second.error, both.error));
    EXPECT_NEAR(both.mean, first.mean + second.mean - none.mean, 4 * error);
    EXPECT_LT(error, 0.02 * both.mean);
    EXPECT_GT(first.mean, none.mean + 4 * error);
}

// One ray each, whatever the number of shadow samples.
TEST(DeltaLights, InTheDistributedIntegrator_TakeOneRay) {
    const SceneDescription scene = floor_under(cases()[0].light).scene;
    DistributedSettings settings = whitted(0);
    settings.shadow_samples = 16;
    EXPECT_EQ(
        DistributedScene(scene).trace(settings, Vec3(0, -1, 1), Vec3(0, 1, -1)).count.shadow_rays,
        1U);
}

}  // namespace
}  // namespace carom::render
