// Directions of reflected and refracted rays.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/render/integrator/distributed_scene.h"

namespace carom::render {
namespace {

using test::DistributedScene;
using test::grey;
using test::phong_black;
using test::SceneBuilder;
using test::Traced;
using test::whitted;

PhongMaterial mirror(double fraction, double spread = 0) {
    PhongMaterial material = phong_black();
    material.reflectance = grey(fraction);
    material.reflectance_spread = spread;
    return material;
}

PhongMaterial glass(double fraction, double index, double spread = 0) {
    PhongMaterial material = phong_black();
    material.transmittance = grey(fraction);
    material.transmittance_spread = spread;
    material.index = index;
    return material;
}

TEST(WhittedTracer, MirrorPlane_ShowsTheBulbWhereItsImageIs) {
    // With a count of 1 the spread does not matter.
    SceneBuilder builder;
    builder.phong("mirror", mirror(0.5, 0.3)).object("floor", PlaneShape{}, Vec3(0), "mirror");
    builder.bulb(Vec3(0, 2, 2), 0.01, 10);
    const DistributedScene scene(builder.scene);
    EXPECT_FLOAT_EQ(scene.trace(whitted(1), Vec3(0, -1, 1), Vec3(0, 1, -1)).sample.radiance.x, 5);
    EXPECT_EQ(scene.trace(whitted(1), Vec3(0, -1, 1), Vec3(0, 1.02, -1)).sample.radiance.x, 0);
    EXPECT_EQ(scene.trace(whitted(0), Vec3(0, -1, 1), Vec3(0, 1, -1)).sample.radiance.x, 0);
}

TEST(WhittedTracer, GlassBall_BendsARayTwiceBySnellsLaw) {
    // A ray at distance sin(i) from the centre of a unit ball enters at the angle of incidence i,
    // leaves at the angle 2 t - i of the ball and is deflected by 2 (i - t) in total, sin(t) =
    // sin(i) / index.
    for (const double i : {0.2, 0.7, 1.2}) {
        const double t = std::asin(std::sin(i) / 1.5);
        const Vec3 leaves(std::cos(2 * t - i), 0, std::sin(2 * t - i));
        const Vec3 onward(std::cos(2 * (i - t)), 0, -std::sin(2 * (i - t)));
        SceneBuilder builder;
        builder.phong("glass", glass(0.9, 1.5)).sphere("ball", 1, Vec3(0), "glass");
        builder.bulb(leaves + 5.0 * onward, 0.01, 10);
        const DistributedScene scene(builder.scene);
        const Vec3 origin(-5, 0, std::sin(i));
        const Traced seen = scene.trace(whitted(2), origin, Vec3(1, 0, 0));
        EXPECT_FLOAT_EQ(seen.sample.radiance.x, 8.1f) << i;
        EXPECT_EQ(seen.count.refraction_rays, 2u);
        EXPECT_EQ(seen.count.reflection_rays, 0u);
    }
}

TEST(WhittedTracer, InsideGlass_ReflectsTotallyBeyondTheCriticalAngle) {
    // The plane's inside is below; the critical angle of 1.5 is 41.81 degrees.
    SceneBuilder builder;
    builder.phong("glass", glass(0.8, 1.5)).object("water", PlaneShape{}, Vec3(0), "glass");
    builder.bulb(Vec3(0, 2 * std::tan(42 * std::numbers::pi / 180), -2), 0.02, 10);
    builder.environment(1);
    const DistributedScene scene(builder.scene);
    const auto from_below = [&](double degrees) {
        const double y = std::tan(degrees * std::numbers::pi / 180);
        return scene.trace(whitted(1), Vec3(0, -y, -1), Vec3(0, y, 1));
    };
    const Traced beyond = from_below(42);
    EXPECT_FLOAT_EQ(beyond.sample.radiance.x, 8);
    EXPECT_EQ(beyond.count.reflection_rays, 1u);
    EXPECT_EQ(beyond.count.refraction_rays, 0u);
    const Traced within = from_below(41.5);
    EXPECT_FLOAT_EQ(within.sample.radiance.x, 0.8f);
    EXPECT_EQ(within.count.reflection_rays, 0u);
    EXPECT_EQ(within.count.refraction_rays, 1u);
}

TEST(WhittedTracer, NumbersOfTheSample_DoNotMatter) {
    SceneBuilder builder;
    PhongMaterial both = mirror(0.4, 0.3);
    both.transmittance = grey(0.4);
    both.transmittance_spread = 0.2;
    both.diffuse = grey(0.5);
    builder.phong("both", both).sphere("ball", 1, Vec3(0), "both");
    builder.object("floor", PlaneShape{}, Vec3(0, 0, -1), "both");
    builder.lamp(Vec3(1, 0, 4), 0.5, 0.5, 10).bulb(Vec3(-3, 1, 3), 0.3, 5).environment(0.3);
    const DistributedScene scene(builder.scene);
    const Vec3 direction(0.1, 1, -0.1);
    const Traced first = scene.trace(whitted(4), Vec3(0, -4, 0.5), direction, 0);
    EXPECT_GT(first.sample.radiance.x, 0.1f);
    for (std::uint32_t sample = 1; sample < 8; ++sample) {
        const Traced other = scene.trace(whitted(4), Vec3(0, -4, 0.5), direction, sample);
        EXPECT_EQ(other.sample.radiance, first.sample.radiance);
    }
}

TEST(Gloss, SeenUnderAStripOfLight_IsTheWeightedFractionOfTheDistribution) {
    // Straight down on a glossy plane: the mirror direction is up. A light with the half angle a
    // around it is hit by the fraction of angles below a, each weighted by its cosine: L int_0^a
    // cos(x) exp(-x^2/2s^2) dx / int_0^(pi/2) cos(x) exp(-x^2/2s^2) dx.
    const double spread = 0.3;
    const double radius = 0.5;
    const double distance = 2;
    SceneBuilder builder;
    builder.phong("gloss", mirror(1, spread)).object("floor", PlaneShape{}, Vec3(0), "gloss");
    builder.bulb(Vec3(0, 0, distance), radius, 10);
    DistributedSettings settings = whitted(1);
    settings.reflection_samples = 64;
    const double half_angle = std::asin(radius / distance);
    const auto integral = [&](double to) {
        double sum = 0;
        const int cells = 10'000;
        for (int k = 0; k < cells; ++k) {
            const double x = to * (k + 0.5) / cells;
            sum += std::cos(x) * std::exp(-x * x / (2 * spread * spread)) * to / cells;
        }
        return sum;
    };
    const double exact = 10 * integral(half_angle) / integral(std::numbers::pi / 2);
    const DistributedScene scene(builder.scene);
    // From just above the floor, not through the bulb.
    EXPECT_NEAR(scene.mean(settings, Vec3(0, 0, 0.1), Vec3(0, 0, -1), 256), exact, 0.01 * exact);
}

TEST(Furnace, BallThatSendsEverythingOn_CannotBeSeen) {
    SceneBuilder builder;
    builder.environment(1).phong("gloss", mirror(1, 0.4)).phong("glass", glass(1, 1.5));
    builder.sphere("gloss", 1, Vec3(-2, 0, 0), "gloss").sphere("glass", 1, Vec3(2, 0, 0), "glass");
    const DistributedScene scene(builder.scene);
    DistributedSettings settings = whitted(6);
    settings.reflection_samples = 4;
    for (double x = -0.95; x <= 0.95; x += 0.19) {
        for (const double middle : {-2.0, 2.0}) {
            const Traced seen = scene.trace(settings, Vec3(middle + x, -5, 0), Vec3(0, 1, 0));
            EXPECT_EQ(seen.sample.coverage, 1);
            EXPECT_NEAR(seen.sample.radiance.x, 1, 1e-5f) << middle + x;
        }
    }
}

}  // namespace
}  // namespace carom::render
