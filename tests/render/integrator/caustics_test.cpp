#include "render/integrator/caustics.h"

#include <gtest/gtest.h>

#include "tests/render/integrator/integrator_scene.h"

namespace carom::render {
namespace {

using test::Estimate;
using test::SceneBuilder;

/// Two smooth balls on a floor with a wide highlight, one coated and one of polished metal; without
/// lights.
SceneBuilder mirrors_on_floor() {
    SceneBuilder builder;
    StandardMaterial phenolic;
    phenolic.base = Vec3(0.02, 0.02, 0.02);
    phenolic.coat = {1, 2.5, 0};
    StandardMaterial metal;
    metal.base = Vec3(0.9, 0.7, 0.5);
    metal.metal = 1;
    metal.roughness = 0;
    StandardMaterial floor;
    floor.base = Vec3(0.5, 0.5, 0.5);
    floor.specular = 0.5;
    floor.roughness = 0.6;
    builder.material("phenolic", phenolic).material("metal", metal).material("floor", floor);
    builder.object("floor", PlaneShape{}, Vec3(0, 0, 0), "floor");
    builder.sphere("a", 0.3, Vec3(-0.4, 0, 0.3), "phenolic");
    builder.sphere("b", 0.2, Vec3(0.35, 0.2, 0.2), "metal");
    return builder;
}

Estimate seen(const SceneDescription& scene, bool caustics, int bounces) {
    PathSettings path;
    path.caustics = caustics;
    path.max_bounces = bounces;
    // Between the balls, in the shadow of one and beside the other.
    return test::picture_luminance(scene, test::camera(Vec3(0, -1.6, 1.4), Vec3(0, -0.05, 0), 0.2),
                                   path, 32, 64);
}

/// With a lamp and a bulb so near that their caustics are a good part of what is seen on the floor.
Estimate seen(bool caustics, int bounces) {
    SceneBuilder builder = mirrors_on_floor();
    builder.lamp(Vec3(0.9, -0.4, 1), 0.15, 0.1, 40).bulb(Vec3(-1.2, -0.8, 0.5), 0.12, 60);
    return seen(builder.scene, caustics, bounces);
}

Estimate seen_by(const LightDescription& light) {
    SceneDescription scene = mirrors_on_floor().scene;
    scene.lights.push_back(light);
    return seen(scene, true, 1);
}

LightDescription small_bulb(const Vec3& centre, double radius, double intensity) {
    return {"bulb", SphereLight{centre, radius, Vec3(intensity / (M_PI * radius * radius))}};
}

TEST(Caustics, SampledOrFoundByChance_HaveTheSameMean) {
    for (const int bounces : {1, 3}) {
        const Estimate sampled = seen(true, bounces);
        const Estimate by_chance = seen(false, bounces);
        EXPECT_NEAR(sampled.mean, by_chance.mean, 4 * std::hypot(sampled.error, by_chance.error))
            << bounces;
        EXPECT_LT(sampled.error, 0.2 * by_chance.error) << bounces;
        EXPECT_LT(by_chance.error, 0.01 * by_chance.mean) << bounces;
    }
}

/// The gap between two billiard balls that touch, a metre from the origin.
Estimate gap(bool caustics) {
    SceneBuilder builder;
    StandardMaterial phenolic;
    phenolic.base = Vec3(0.5, 0.5, 0.5);
    phenolic.coat = {1, 2.5, 0};
    builder.material("phenolic", phenolic);
    constexpr double kRadius = 0.0286;
    builder.sphere("a", kRadius, Vec3(0.8 - kRadius, 0.4, kRadius), "phenolic");
    builder.sphere("b", kRadius, Vec3(0.8 + kRadius, 0.4, kRadius), "phenolic");
    builder.lamp(Vec3(0.8, 0.4, 0.6), 0.3, 0.3, 10);
    PathSettings path;
    path.caustics = caustics;
    path.max_bounces = 1;
    return test::picture_luminance(
        builder.scene, test::camera(Vec3(0.8, 0.4 - 0.05, 0.25), Vec3(0.8, 0.4, kRadius), 0.03),
        path, 32, 64);
}

TEST(Caustics, BetweenBallsThatTouch_AreNotLost) {
    const Estimate sampled = gap(true);
    const Estimate by_chance = gap(false);
    EXPECT_NEAR(sampled.mean, by_chance.mean, 4 * std::hypot(sampled.error, by_chance.error));
    EXPECT_LT(by_chance.error, 0.005 * by_chance.mean);
}

TEST(Caustics, AddLight) {
    // Without a bounce no specular reflection is followed: the sampled caustics must respect the
    // limit.
    EXPECT_EQ(seen(true, 0).mean, seen(false, 0).mean);
    const double without = seen(true, 0).mean;
    EXPECT_GT(seen(true, 1).mean, 1.02 * without);
}

// Delta lights are the limit of small lights, including their caustics.
TEST(Caustics, OfAPoint_AreThoseOfASmallBulb) {
    const Vec3 place(-0.9, -0.5, 0.4);
    const Estimate point = seen_by({"point", PointLight{place, Vec3(3)}});
    const Estimate spot =
        seen_by({"spot", SpotLight{place, Vec3(1, 0.5, -0.2), Vec3(3), 3.0, 3.1}});
    const Estimate bulb = seen_by(small_bulb(place, 0.004, 3));
    EXPECT_NEAR(point.mean, bulb.mean, 4 * std::hypot(point.error, bulb.error));
    EXPECT_NEAR(spot.mean, bulb.mean, 4 * std::hypot(spot.error, bulb.error));
    EXPECT_LT(bulb.error, 0.003 * bulb.mean);
    EXPECT_LT(point.error, 0.003 * bulb.mean);
}

TEST(Caustics, OfParallelLight_AreThoseOfAFarBulb) {
    const Vec3 direction(-0.3, 1, -0.9);  // from behind the camera
    constexpr double kFar = 5000;
    const Estimate sun = seen_by({"sun", DirectionalLight{direction, Vec3(3)}});
    const Estimate bulb =
        seen_by(small_bulb(direction.normalized() * -kFar, 0.004 * kFar, 3 * kFar * kFar));
    EXPECT_NEAR(sun.mean, bulb.mean, 4 * std::hypot(sun.error, bulb.error));
    EXPECT_LT(bulb.error, 0.003 * bulb.mean);
    EXPECT_LT(sun.error, 0.003 * bulb.mean);
}

/// A floor below a ball of clear glass, and the light of a lamp behind it.
SceneBuilder glass_over_floor() {
    SceneBuilder builder;
    StandardMaterial glass;
    glass.transmission = 1;
    glass.ior = 1.5;
    glass.roughness = 0;
    glass.transmission_colour = Vec3(0.9, 0.95, 0.8);
    builder.diffuse("floor", 0.5).material("glass", glass);
    builder.object("floor", PlaneShape{}, Vec3(0, 0, 0), "floor");
    return builder.sphere("ball", 0.2, Vec3(0, 0, 0.35), "glass");
}

Estimate seen_below(const SceneDescription& scene, bool caustics, int bounces) {
    PathSettings path;
    path.caustics = caustics;
    path.max_bounces = bounces;
    return test::picture_luminance(
        scene, test::camera(Vec3(0, -1.4, 0.5), Vec3(-0.05, -0.05, 0), 0.25), path, 32, 64);
}

// Chance hits are so rare that their error is several percent; the spread of each path is tested
// exactly in refracted_paths_test.cpp.
TEST(Caustics, ThroughClearGlass_SampledOrFoundByChance_HaveTheSameMean) {
    const SceneDescription scene = glass_over_floor().bulb(Vec3(0.3, 0.2, 1.6), 0.02, 1200).scene;
    for (const int bounces : {1, 4}) {
        const Estimate sampled = seen_below(scene, true, bounces);
        const Estimate by_chance = seen_below(scene, false, bounces);
        EXPECT_NEAR(sampled.mean, by_chance.mean, 4 * std::hypot(sampled.error, by_chance.error))
            << bounces;
        EXPECT_LT(sampled.error, by_chance.error) << bounces;
    }
    // Nearer to the floor or farther from it than its focus the ball concentrates light less.
    SceneBuilder far = glass_over_floor().bulb(Vec3(0.3, 0.2, 1.6), 0.02, 1200);
    far.scene.objects.back().world_from_object = test::moved_to(Vec3(0, 0, 0.25));
    EXPECT_LT(3 * seen_below(far.scene, true, 1).error, seen_below(far.scene, false, 1).error);
}

// A lamp that looks larger is left to chance hits.
TEST(Caustics, ThroughClearGlass_OfLargerLamps_AreFoundByChance) {
    const SceneDescription scene = glass_over_floor().bulb(Vec3(0.3, 0.2, 1.6), 0.09, 60).scene;
    EXPECT_EQ(seen_below(scene, true, 4).mean, seen_below(scene, false, 4).mean);
}

TEST(Caustics, ThroughClearGlass_OfAPoint_AreThoseOfASmallBulb) {
    const Vec3 place(0.3, 0.2, 1.6);
    SceneBuilder point = glass_over_floor();
    point.scene.lights.push_back({"point", PointLight{place, Vec3(2)}});
    SceneBuilder bulb = glass_over_floor();
    bulb.scene.lights.push_back(small_bulb(place, 0.004, 2));
    const Estimate by_point = seen_below(point.scene, true, 1);
    const Estimate by_bulb = seen_below(bulb.scene, true, 1);
    EXPECT_NEAR(by_point.mean, by_bulb.mean, 4 * std::hypot(by_point.error, by_bulb.error));
    const Estimate unlit = seen_below(point.scene, false, 1);
    EXPECT_GT(by_point.mean, 1.05 * unlit.mean);
}

}  // namespace
}  // namespace carom::render
