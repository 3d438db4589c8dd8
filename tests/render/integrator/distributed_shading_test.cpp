// Ambient, diffuse and specular terms, and soft shadows.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/render/integrator/distributed_scene.h"
#include "tests/render/integrator/integrator_scene.h"

namespace carom::render {
namespace {

using test::DistributedScene;
using test::grey;
using test::phong_black;
using test::SceneBuilder;
using test::whitted;

TEST(PhongTerms, UnderABulb_FollowTheirFormulas) {
    // A bulb of radius r at distance d gives I = L 2 (1 - sqrt(1 - (r/d)^2)) along its axis.
    PhongMaterial material;
    material.ambient = Vec3(0.3, 0.3, 0.3);
    material.diffuse = Vec3(0.6, 0.6, 0.6);
    material.specular = Vec3(0.7, 0.7, 0.7);
    material.shininess = 30;
    SceneBuilder builder;
    builder.phong("floor", material).object("floor", PlaneShape{}, Vec3(0), "floor");
    const Vec3 bulb(0, 2, 2);
    builder.bulb(bulb, 0.2, 50);
    const DistributedScene scene(builder.scene);
    DistributedSettings settings = whitted(0);
    settings.ambient_coefficient = 0.12;
    const double intensity = 50 * 2 * (1 - std::sqrt(1 - 0.04 / bulb.length2()));
    const double cosine = std::numbers::sqrt2 / 2;
    for (const double degrees : {-10.0, 0.0, 5.0, 20.0}) {
        // Seen at that angle from the mirror direction of the light.
        const double elevation = std::numbers::pi / 4 + degrees * std::numbers::pi / 180;
        const Vec3 eye(0, -std::cos(elevation), std::sin(elevation));
        const double highlight = std::pow(std::cos(degrees * std::numbers::pi / 180), 30);
        const double exact = 0.12 * 0.3 + intensity * (0.6 * cosine + 0.7 * highlight);
        EXPECT_NEAR(scene.trace(settings, eye, -eye).sample.radiance.x, exact, 1e-4 * exact)
            << degrees;
    }
}

TEST(PhongTerms, AmbientWithoutAColourOfItsOwn_IsThatOfTheDiffuseTerm) {
    PhongMaterial material;
    material.diffuse = Vec3(0.25, 0.5, 1);
    SceneBuilder builder;
    builder.phong("floor", material).object("floor", PlaneShape{}, Vec3(0), "floor");
    DistributedSettings settings = whitted(0);
    settings.ambient_coefficient = 0.2;
    const V3f seen = DistributedScene(builder.scene)
                         .trace(settings, Vec3(0, 0, 1), Vec3(0, 0, -1))
                         .sample.radiance;
    EXPECT_NEAR(seen.x, 0.05f, 1e-6f);
    EXPECT_NEAR(seen.y, 0.1f, 1e-6f);
    EXPECT_NEAR(seen.z, 0.2f, 1e-6f);
}

TEST(LayeredMaterials, AsPhong_ReflectWhatTheyReflectStraightOn) {
    // A coat of index 1.5 reflects 4 %, over which the base keeps 96 %; a metal reflects its base.
    StandardMaterial coated;
    coated.base = Vec3(0.5, 0.5, 0.5);
    coated.coat.weight = 1;
    StandardMaterial metal;
    metal.base = Vec3(0.9, 0.9, 0.9);
    metal.metal = 1;
    metal.roughness = 0.5;
    SceneBuilder builder;
    builder.material("coated", coated).material("metal", metal).environment(2);
    builder.sphere("a", 1, Vec3(0), "coated").sphere("b", 1, Vec3(5, 0, 0), "metal");
    const DistributedScene scene(builder.scene);
    DistributedSettings settings = whitted(1);
    settings.ambient_coefficient = 0.1;
    settings.reflection_samples = 8;
    const auto seen = [&](double x) {
        return scene.trace(settings, Vec3(x, -5, 0), Vec3(0, 1, 0));
    };
    EXPECT_NEAR(seen(0).sample.radiance.x, 2 * 0.04 + 0.1 * 0.96 * 0.5, 1e-5);
    EXPECT_EQ(seen(0).count.reflection_rays, 1u);  // a smooth coat needs only one
    EXPECT_NEAR(seen(5).sample.radiance.x, 2 * 0.9, 1e-5);
    EXPECT_EQ(seen(5).count.reflection_rays, 8u);
}

TEST(LayeredMaterials, RoughHighlight_HasTheAlbedoOfItsReflectance) {
    // Integrated over the hemisphere of light directions at normal incidence, each weighted by 1 /
    // pi for I: the lobe k_s cos^n has the albedo 2 k_s / (n + 2) with a cosine, which is f to a
    // part in n.
    StandardMaterial plastic;
    plastic.base = Vec3(0, 0, 0);
    plastic.specular = 1;
    plastic.roughness = 0.4;
    const PhongModel model = phong_model(plastic);
    EXPECT_NEAR(model.specular.x * 2 / (model.shininess + 2), 0.04, 1e-6);
    EXPECT_GT(model.shininess, 10);
}

TEST(DiffuseFloor, UnderARectangle_IsAsBrightAsByPathTracing) {
    // One bounce of light off a diffuse floor: both integrators and the form factor of a parallel
    // rectangle (Howell, "A catalog of radiation heat transfer configuration factors", B-4).
    SceneBuilder builder;
    builder.diffuse("floor", 0.5).object("floor", PlaneShape{}, Vec3(0), "floor");
    builder.lamp(Vec3(0, 0, 1.2), 0.6, 0.3, 10);
    const Vec3 eye(0, -1, 0.5);
    PathSettings path;
    path.max_bounces = 0;
    const test::Estimate by_path =
        test::picture_luminance(builder.scene, test::camera(eye, Vec3(0), 0.002), path, 8, 16);
    DistributedSettings settings = whitted(0);
    settings.shadow_samples = 16;
    const double distributed = DistributedScene(builder.scene).mean(settings, eye, -eye, 256);
    const double a = 0.5;
    const double b = 0.25;
    const double ra = std::sqrt(1 + a * a);
    const double rb = std::sqrt(1 + b * b);
    const double factor =
        2 / std::numbers::pi * (a / ra * std::atan(b / ra) + b / rb * std::atan(a / rb));
    EXPECT_NEAR(distributed, 5 * factor, 5e-4 * 5 * factor);
    EXPECT_NEAR(distributed, by_path.mean, 4 * by_path.error + 5e-4 * by_path.mean);
}

/// A lamp 0.2 m wide at 10 m above the floor and a board at 1 m that covers x < 0: from the floor
/// at x the part of the lamp beyond -9 x is visible.
class Penumbra : public testing::Test {
  protected:
    Penumbra() {
        PhongMaterial floor = phong_black();
        floor.diffuse = Vec3(0.5, 0.5, 0.5);
        builder_.phong("floor", floor).object("floor", PlaneShape{}, Vec3(0), "floor");
        builder_.object("board", BoxShape{Vec3(2, 2, 1e-4)}, Vec3(-1, 0, 1), "floor");
        builder_.lamp(Vec3(0, 0, 10), 0.1, 0.1, 1000);
    }
    double lit_fraction(const DistributedSettings& settings, double x) const {
        // Without occlusion, a floor of albedo 0.5 has 0.5 L A / (pi h^2), to within 1e-3.
        const double open = 0.5 * 1000 * 0.04 / (std::numbers::pi * 100);
        const Vec3 eye(x, -0.1, 0.5);
        return DistributedScene(builder_.scene).mean(settings, eye, Vec3(x, 0, 0) - eye, 64) / open;
    }
    SceneBuilder builder_;
};

TEST_F(Penumbra, SoftShadow_GrowsInProportionToTheLampThatIsSeen) {
    DistributedSettings settings = whitted(0);
    settings.shadow_samples = 64;
    for (const double x : {-0.02, -0.008, -0.004, 0.0, 0.004, 0.008, 0.02}) {
        const double exact = std::clamp((0.1 + 9 * x) / 0.2, 0.0, 1.0);
        EXPECT_NEAR(lit_fraction(settings, x), exact, 0.005) << x;
    }
}

TEST_F(Penumbra, OneShadowSample_MakesAHardEdgeWhereTheLampsMiddleIsHidden) {
    EXPECT_EQ(lit_fraction(whitted(0), -0.001), 0);
    EXPECT_NEAR(lit_fraction(whitted(0), 0.001), 1, 1e-3);
}

}  // namespace
}  // namespace carom::render
