#include "render/integrator/path_integrator.h"

#include <numbers>

#include <gtest/gtest.h>

#include "render/material/scalar_kernels.h"
#include "tests/render/integrator/integrator_scene.h"

namespace carom::render {
namespace {

using scalar::One;

using test::Estimate;
using test::SceneBuilder;

PathSettings bounces(int count) {
    PathSettings path;
    path.max_bounces = count;
    return path;
}

TEST(PathIntegrator, FloorUnderALamp_ShowsLambertsFormFactor) {
    // Radiance of a diffuse floor straight below the centre of a parallel rectangle a x b at height
    // c: albedo L F, with (Howell, "A catalog of radiation heat transfer configuration factors",
    // B-4, four quarters) F = 2/pi (A/sqrt(1+A^2) atan(B/sqrt(1+A^2)) + B/sqrt(1+B^2)
    // atan(A/sqrt(1+B^2))), A = a/2c, B = b/2c.
    SceneBuilder builder;
    builder.diffuse("floor", 0.5).object("floor", PlaneShape{}, Vec3(0, 0, 0), "floor");
    builder.lamp(Vec3(0, 0, 1.2), 0.6, 0.3, 10);
    CameraState state = test::camera(Vec3(0, -1, 0.5), Vec3(0, 0, 0), 0.002);
    const Estimate seen = test::picture_luminance(builder.scene, state, bounces(0), 8, 16);
    const double a = 0.6 / 1.2;
    const double b = 0.3 / 1.2;
    const double ra = std::sqrt(1 + a * a);
    const double rb = std::sqrt(1 + b * b);
    const double factor =
        2 / std::numbers::pi * (a / ra * std::atan(b / ra) + b / rb * std::atan(a / rb));
    const double exact = 0.5 * 10 * factor;
    EXPECT_NEAR(seen.mean, exact, 4 * seen.error + 1e-4 * exact);
    EXPECT_LT(seen.error, 2e-3 * exact);
}

TEST(PathIntegrator, LampInASmoothCoat_IsSeenWithFresnelsReflectance) {
    // A black lacquered floor seen at 45 degrees shows the lamp's radiance times F(45 degrees).
    SceneBuilder builder;
    StandardMaterial black;
    black.base = Vec3(0, 0, 0);
    black.coat.weight = 1;
    builder.material("black", black).object("floor", PlaneShape{}, Vec3(0, 0, 0), "black");
    builder.lamp(Vec3(0, 1, 1), 0.5, 0.5, 10);
    const CameraState state = test::camera(Vec3(0, -1, 1), Vec3(0, 0, 0), 0.01);
    const Estimate seen = test::picture_luminance(builder.scene, state, bounces(0), 4, 2);
    EXPECT_NEAR(seen.mean, 10 * scalar::fresnel_dielectric<One>(std::sqrt(0.5f), 1.5f), 0.01);
}

TEST(PathIntegrator, LampFromBehind_IsInvisible) {
    SceneBuilder builder;
    builder.lamp(Vec3(0, 0, 1), 5, 5, 10).environment(0.25);
    const CameraState above = test::camera(Vec3(0, 0, 3), Vec3(0, 0, 0), 0.1);
    EXPECT_NEAR(test::picture_luminance(builder.scene, above, bounces(0), 2, 2).mean, 0.25, 1e-6);
    const CameraState below = test::camera(Vec3(0, 0, -3), Vec3(0, 0, 0), 0.1);
    EXPECT_NEAR(test::picture_luminance(builder.scene, below, bounces(0), 2, 2).mean, 10, 1e-5);
}

TEST(PathIntegrator, BehindAnotherLight_ASurfaceIsInItsShadow) {
    // Inverse square: a small bulb at height h over a floor, E = pi L (r / h)^2 straight below.
    SceneBuilder builder;
    builder.diffuse("floor", 1).object("floor", PlaneShape{}, Vec3(0, 0, 0), "floor");
    const CameraState state = test::camera(Vec3(0, -1, 0.2), Vec3(0, 0, 0), 0.002);
    builder.bulb(Vec3(0, 0, 2), 0.1, 100);
    const Estimate open = test::picture_luminance(builder.scene, state, bounces(0), 4, 16);
    EXPECT_NEAR(open.mean, 100 * 0.01 / 4, 0.002);
    SceneBuilder shaded = builder;
    shaded.bulb(Vec3(0, 0, 1), 0.2, 0);
    EXPECT_EQ(test::picture_luminance(shaded.scene, state, bounces(0), 4, 16).mean, 0);
}

TEST(PathIntegrator, NoBounces_IsDirectLightAndEveryBounceAddsSome) {
    SceneBuilder builder;
    builder.diffuse("wall", 0.7).sphere("wall", 2, Vec3(0, 0, 0), "wall");
    builder.lamp(Vec3(0, 0, 1.2), 0.4, 0.4, 10);
    const CameraState state = test::camera(Vec3(0, -1, 0), Vec3(0, 1, -0.6), 0.6);
    double last = 0;
    for (const int count : {0, 1, 2, 4}) {
        const Estimate seen = test::picture_luminance(builder.scene, state, bounces(count), 4, 16);
        EXPECT_GT(seen.mean, last * 1.05) << count;
        last = seen.mean;
    }
}

TEST(PathIntegrator, FollowedBothOrChosen_TheCoatHasTheSameMeanAndLessNoise) {
    SceneBuilder builder;
    StandardMaterial smooth;
    smooth.base = Vec3(0.5, 0.4, 0.3);
    smooth.coat.weight = 1;
    StandardMaterial rough = smooth;
    rough.coat.roughness = 0.4;
    builder.material("smooth", smooth).material("rough", rough).diffuse("floor", 0.6);
    builder.object("floor", PlaneShape{}, Vec3(0, 0, 0), "floor").environment(0.3);
    builder.sphere("a", 0.4, Vec3(-0.42, 0, 0.4), "smooth");
    builder.sphere("b", 0.4, Vec3(0.42, 0, 0.4), "rough");
    builder.lamp(Vec3(0, -0.5, 1.9), 0.6, 0.6, 4);
    const CameraState state = test::camera(Vec3(0, -2.5, 0.8), Vec3(0, 0, 0.4), 0.4);
    PathSettings path = bounces(3);
    const Estimate followed = test::picture_luminance(builder.scene, state, path, 24, 16);
    path.split_vertices = 0;
    const Estimate chosen = test::picture_luminance(builder.scene, state, path, 24, 16);
    EXPECT_NEAR(followed.mean, chosen.mean, 4 * std::hypot(followed.error, chosen.error));
    EXPECT_LT(followed.error, chosen.error);
}

}  // namespace
}  // namespace carom::render
