// Emissive objects against lights of the same shape, and phong surfaces in both integrators.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/render/integrator/distributed_scene.h"
#include "tests/render/integrator/every_shape.h"
#include "tests/render/integrator/integrator_scene.h"

namespace carom::render {
namespace {

using test::DistributedScene;
using test::Estimate;
using test::SceneBuilder;
using test::whitted;

/// A ball on a floor, without any light.
SceneBuilder unlit() {
    SceneBuilder builder;
    builder.diffuse("white", 0.6).object("floor", PlaneShape{}, Vec3(0), "white");
    StandardMaterial lacquer;
    lacquer.base = Vec3(0.5, 0.2, 0.1);
    lacquer.coat = {1, 1.5, 0.3};
    builder.material("lacquer", lacquer).sphere("ball", 0.3, Vec3(0.2, 0, 0.3), "lacquer");
    StandardMaterial glow;
    glow.base = Vec3(0, 0, 0);
    glow.emission = Vec3(4, 4, 4);
    builder.material("glow", glow);
    return builder;
}

/// 0.8 by 0.6, facing down.
const ParallelogramShape kPanel{{-0.4, 0.3, 0}, {0.8, 0, 0}, {0, -0.6, 0}};

Estimate seen(const SceneBuilder& builder, DirectStrategy strategy, int bounces,
              const test::Motion& motion = {}) {
    PathSettings path;
    path.strategy = strategy;
    path.max_bounces = bounces;
    return test::picture_luminance(builder.scene,
                                   test::camera(Vec3(0, -2.2, 0.9), Vec3(0, 0, 0.3), 0.7), path, 16,
                                   16, motion);
}

TEST(Emission, EmissiveRectangle_IsALamp) {
    const SceneBuilder panel = unlit().object("panel", kPanel, Vec3(0, 0, 1.3), "glow");
    const SceneBuilder lamp = unlit().lamp(Vec3(0, 0, 1.3), 0.4, 0.3, 4);
    for (const int bounces : {0, 2}) {
        const Estimate as_object = seen(panel, DirectStrategy::both, bounces);
        const Estimate as_light = seen(lamp, DirectStrategy::both, bounces);
        // From behind, the panel is black and the lamp invisible; the camera sees neither.
        EXPECT_NEAR(as_object.mean, as_light.mean, 4 * std::hypot(as_object.error, as_light.error))
            << bounces;
        EXPECT_LT(as_object.error, 0.01 * as_object.mean);
    }
}

TEST(Emission, EveryStrategy_HasTheSameMean) {
    SceneBuilder builder = unlit().object("panel", kPanel, Vec3(0, 0, 1.3), "glow");
    builder.object("cube", BoxShape{{0.2, 0.2, 0.2}}, Vec3(-0.5, 0, 0.15), "glow");
    builder.environment(0.02).lamp(Vec3(1, 0, 1.2), 0.2, 0.2, 3);
    for (const int bounces : {0, 2}) {
        const Estimate both = seen(builder, DirectStrategy::both, bounces);
        const Estimate lights = seen(builder, DirectStrategy::lights_only, bounces);
        const Estimate scattering = seen(builder, DirectStrategy::scattering_only, bounces);
        EXPECT_NEAR(lights.mean, both.mean, 4 * std::hypot(lights.error, both.error)) << bounces;
        EXPECT_NEAR(scattering.mean, both.mean, 4 * std::hypot(scattering.error, both.error))
            << bounces;
        EXPECT_LT(both.error, scattering.error);
    }
}

/// A surface whose emission and opacity vary is sampled as a light of one radiance; what arrives is
/// what it emits there.
TEST(Emission, OfPicturesAndPatterns_HasTheSameMeanByEveryStrategy) {
    CheckerTexture checker;
    checker.even = Vec3(6, 1, 1);
    checker.odd = Vec3(0, 1, 0);
    checker.size = 0.15;
    for (const bool is_cut_out : {false, true}) {
        StandardMaterial screen;
        screen.base = Vec3(0, 0, 0);
        screen.emission = checker;
        screen.emission_strength = 1.5;
        CheckerTexture holes = checker;
        holes.even = Vec3(0, 0, 0);
        holes.odd = Vec3(1, 1, 1);
        holes.size = 0.22;
        if (is_cut_out) {
            screen.opacity = NumberTexture{holes, {0.2, 0.9}};
        }
        SceneBuilder builder = unlit().material("screen", screen);
        builder.object("screen", kPanel, Vec3(0, 0, 1.3), "screen");
        builder.sphere("bulb", 0.1, Vec3(-0.6, 0, 0.15), "screen");
        for (const int bounces : {0, 2}) {
            const Estimate both = seen(builder, DirectStrategy::both, bounces);
            const Estimate lights = seen(builder, DirectStrategy::lights_only, bounces);
            const Estimate scattering = seen(builder, DirectStrategy::scattering_only, bounces);
            EXPECT_NEAR(lights.mean, both.mean, 4 * std::hypot(lights.error, both.error))
                << bounces << is_cut_out;
            EXPECT_NEAR(scattering.mean, both.mean, 4 * std::hypot(scattering.error, both.error))
                << bounces << is_cut_out;
            EXPECT_LT(both.error, scattering.error);
        }
    }
}

/// 200 squares of 400 triangles in a row of rows, facing down.
MeshShape board() {
    MeshShape made;
    for (int i = 0; i < 200; ++i) {
        const Vec3 at(0.04 * (i % 20) - 0.4, 0.04 * (i / 20) - 0.2, 0);
        const auto first = static_cast<std::uint32_t>(made.vertices.size());
        for (const Vec3& corner :
             {Vec3(0, 0, 0), Vec3(0, 0.02, 0), Vec3(0.02, 0.02, 0), Vec3(0.02, 0, 0)}) {
            made.vertices.push_back(at + corner);
        }
        made.triangles.push_back({first, first + 1, first + 2});
        made.triangles.push_back({first, first + 2, first + 3});
    }
    return made;
}

// More lights than are sampled one by one: lamps, bulbs, moving shapes of every kind, a moving and
// a resting mesh of many faces.
TEST(Emission, ManyLights_HaveTheSameMeanByEveryStrategy) {
    constexpr double kShutter = 0.02;
    SceneBuilder builder = unlit();
    test::add_every_shape(builder, test::Placement::moving, "glow");
    test::Motion motion{test::tracks_of_every_shape(kShutter), kShutter};
    builder.object("board", board(), Vec3(0, 0.8, 1.2), "glow");
    builder.object("moving board", board(), Vec3(0, 0, 0), "glow", "flies");
    motion.tracks.push_back(
        test::straight_track("flies", Vec3(-0.6, -0.4, 1.2), Vec3(-0.4, -0.5, 1.3), 0, kShutter));
    for (int i = 0; i < 6; ++i) {
        builder.lamp(Vec3(0.4 * i - 1, -0.3, 1.2 + 0.05 * i), 0.05, 0.1, 4 + i);
        builder.bulb(Vec3(0.4 * i - 1, 0.9, 0.3), 0.03, 20);
    }
    for (const int bounces : {0, 2}) {
        const Estimate both = seen(builder, DirectStrategy::both, bounces, motion);
        const Estimate lights = seen(builder, DirectStrategy::lights_only, bounces, motion);
        const Estimate scattering = seen(builder, DirectStrategy::scattering_only, bounces, motion);
        EXPECT_NEAR(lights.mean, both.mean, 4 * std::hypot(lights.error, both.error)) << bounces;
        EXPECT_NEAR(scattering.mean, both.mean, 4 * std::hypot(scattering.error, both.error))
            << bounces;
        EXPECT_LT(both.error, lights.error);  // close to a large light scattering finds it best
    }
}

TEST(Emission, ManyPointsAndSpots_AddUp) {
    const auto light = [](int i) -> LightDescription {
        const Vec3 at(0.2 * i - 1.2, 0.3 * (i % 4) - 0.6, 0.7 + 0.1 * (i % 3));
        if (i % 2 == 0) {
            return {"point", PointLight{at, Vec3(0.2, 0.2, 0.2)}};
        }
        SpotLight spot;
        spot.position = at;
        spot.direction = Vec3(0.1, 0.2, -1);
        spot.intensity = Vec3(0.5, 0.5, 0.5);
        spot.inner_angle = 0.3;
        spot.outer_angle = 0.7;
        return {"spot", spot};
    };
    SceneBuilder all = unlit();
    double sum = 0;
    double error2 = 0;
    for (int i = 0; i < 12; ++i) {
        SceneBuilder one = unlit();
        one.scene.lights.push_back(light(i));
        all.scene.lights.push_back(light(i));
        const Estimate found = seen(one, DirectStrategy::both, 2);
        sum += found.mean;
        error2 += found.error * found.error;
    }
    const Estimate found = seen(all, DirectStrategy::both, 2);
    EXPECT_NEAR(found.mean, sum, 4 * std::sqrt(error2 + found.error * found.error));
    EXPECT_LT(found.error, 0.02 * sum);
}

TEST(Emission, EmissiveBall_IsABulb) {
    const SceneBuilder ball = unlit().sphere("glowing", 0.3, Vec3(-0.6, 0.2, 0.9), "glow");
    const SceneBuilder bulb = unlit().bulb(Vec3(-0.6, 0.2, 0.9), 0.3, 4);
    const Estimate as_object = seen(ball, DirectStrategy::both, 1);
    const Estimate as_light = seen(bulb, DirectStrategy::both, 1);
    EXPECT_NEAR(as_object.mean, as_light.mean, 4 * std::hypot(as_object.error, as_light.error));
    EXPECT_LT(as_object.error, 1.5 * as_light.error);
}

/// A picture of a matt white spot at the origin, of which the camera sees nearly a point, under one
/// emissive object. Returns the spot's irradiance over pi times the radiance of the object.
Estimate lit_spot(const Shape& shape, const std::string& track, const test::Motion& motion,
                  DirectStrategy strategy, int samples) {
    SceneBuilder builder;
    builder.diffuse("white", 1).object("floor", RectangleShape{Vec2(0.2, 0.2)}, Vec3(0), "white");
    StandardMaterial glow;
    glow.base = Vec3(0, 0, 0);
    glow.emission = Vec3(2, 2, 2);
    builder.material("glow", glow).object("light", shape, Vec3(0, 0, 0.8), "glow", track);
    PathSettings path;
    path.strategy = strategy;
    path.max_bounces = 1;
    path.split_vertices = 0;
    Estimate found = test::picture_luminance(builder.scene,
                                             test::camera(Vec3(0, -0.5, 0.2), Vec3(0, 0, 0), 0.001),
                                             path, 16, samples, motion);
    return {found.mean / 2, found.error / 2};
}

// The configuration factor of a small surface that faces a sphere is (radius / distance)^2, that of
// a parallel disk radius^2 / (radius^2 + distance^2) (Howell, "A catalog of radiation heat transfer
// configuration factors", B-13 and B-11).
TEST(Emission, SphereAndDiskAboveASpot_GiveTheClosedForm) {
    constexpr double kHeight = 0.8;
    const Estimate sphere = lit_spot(SphereShape{0.1}, "", {}, DirectStrategy::both, 16);
    EXPECT_NEAR(sphere.mean, 0.01 / (kHeight * kHeight), 4 * sphere.error + 2e-5);
    EXPECT_LT(sphere.error, 0.002 * sphere.mean);
    const Estimate by_chance =
        lit_spot(SphereShape{0.1}, "", {}, DirectStrategy::scattering_only, 16);
    EXPECT_NEAR(by_chance.mean, sphere.mean, 4 * by_chance.error);
    EXPECT_GT(by_chance.error, 10 * sphere.error);  // a hundred times the variance
    // A capsule that is nearly a ball; from below both look alike.
    const Estimate capsule = lit_spot(CapsuleShape{0.1, 1e-4}, "", {}, DirectStrategy::both, 16);
    EXPECT_NEAR(capsule.mean, 0.01 / (kHeight * kHeight), 4 * capsule.error + 2e-5);
}

// The mean over positions at distance x from the vertical of radius^2 height / (height^2 +
// x^2)^(3/2) for x from -a to a is radius^2 / (height sqrt(height^2 + a^2)).
TEST(Emission, BallThatMovesDuringTheShutter_GivesTheMeanOfItsPositions) {
    constexpr double kHeight = 0.8;
    constexpr double kReach = 0.9;
    const test::Motion motion{{test::straight_track("passes", Vec3(-kReach, 0, kHeight),
                                                    Vec3(kReach, 0, kHeight), 0, 0.1)},
                              0.1};
    const double expected = 0.01 / (kHeight * std::hypot(kHeight, kReach));
    const Estimate both = lit_spot(SphereShape{0.1}, "passes", motion, DirectStrategy::both, 64);
    EXPECT_NEAR(both.mean, expected, 4 * both.error + 2e-5);
    EXPECT_LT(both.error, 0.005 * both.mean);
    const Estimate by_chance =
        lit_spot(SphereShape{0.1}, "passes", motion, DirectStrategy::scattering_only, 64);
    EXPECT_NEAR(by_chance.mean, both.mean, 4 * by_chance.error);
    EXPECT_GT(by_chance.error, 5 * both.error);
}

/// A spot of a floor beside one emissive shape, under a ceiling, seen from above.
Estimate beside(const ObjectDescription& shape, const Vec3& place, const test::Motion& motion,
                DirectStrategy strategy) {
    SceneBuilder builder;
    builder.diffuse("white", 0.6).object("floor", PlaneShape{}, Vec3(0), "white");
    builder.object("ceiling", BoxShape{{4, 4, 0.1}}, Vec3(0, 0, 1.3), "white");
    StandardMaterial glow;
    glow.emission = Vec3(4, 4, 4);
    builder.material("glow", glow).scene.objects.push_back(shape);
    PathSettings path;
    path.strategy = strategy;
    path.max_bounces = 1;
    const Vec3 spot(place.x, place.y - 0.5, 0);
    return test::picture_luminance(builder.scene, test::camera(spot + Vec3(0, -0.3, 1), spot, 0.2),
                                   path, 8, 8, motion);
}

// Each shape alone, turned or moving: sampling has the mean of chance hits, and no light counts
// twice or goes missing where both are combined.
TEST(Emission, EveryShape_IsSampledAndHasTheSameMean) {
    constexpr double kShutter = 0.02;
    const std::vector<test::PlacedShape> shapes = test::every_shape();
    for (const auto placement : {test::Placement::turned, test::Placement::moving}) {
        SceneBuilder all;
        test::add_every_shape(all, placement, "glow");
        const test::Motion motion{test::tracks_of_every_shape(kShutter), kShutter};
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            if (shapes[i].name == "plane") {
                continue;  // infinite: hit by chance
            }
            const auto seen = [&](DirectStrategy strategy) {
                return beside(all.scene.objects[i], test::place_of(i, shapes[i].name), motion,
                              strategy);
            };
            const Estimate both = seen(DirectStrategy::both);
            const Estimate lights = seen(DirectStrategy::lights_only);
            const Estimate scattering = seen(DirectStrategy::scattering_only);
            const std::string name =
                shapes[i].name + (placement == test::Placement::moving ? ", moving" : ", turned");
            EXPECT_GT(both.mean, 0.002) << name;
            EXPECT_NEAR(lights.mean, both.mean, 5 * std::hypot(lights.error, both.error)) << name;
            EXPECT_NEAR(scattering.mean, both.mean, 5 * std::hypot(scattering.error, both.error))
                << name;
            EXPECT_LT(1.5 * both.error, scattering.error) << name;
        }
    }
}

TEST(Emission, InTheDistributedIntegrator_LightsTheFloorAndIsSeen) {
    const SceneBuilder panel = unlit().object("panel", kPanel, Vec3(2, 0, 1.3), "glow");
    const SceneBuilder lamp = unlit().lamp(Vec3(2, 0, 1.3), 0.4, 0.3, 4);
    DistributedSettings settings = whitted(0);
    settings.shadow_samples = 64;
    const auto floor = [&](const SceneBuilder& builder) {
        return DistributedScene(builder.scene).mean(settings, Vec3(2, -2, 1), Vec3(0, 2, -1), 16);
    };
    const double by_lamp = floor(lamp);
    EXPECT_GT(by_lamp, 0.05);
    EXPECT_NEAR(floor(panel), by_lamp, 0.02 * by_lamp);
    const auto up = DistributedScene(panel.scene).trace(settings, Vec3(2, 0, 1), Vec3(0, 0, 1));
    EXPECT_EQ(up.sample.radiance.y, 4);
    const auto down = DistributedScene(panel.scene).trace(settings, Vec3(2, 0, 2), Vec3(0, 0, -1));
    EXPECT_EQ(down.sample.radiance.y, 0);  // its back
}

// A matt phong surface is a diffuse one, and the path integrator renders it.
TEST(PhongByPaths, MattSurface_IsADiffuseOne) {
    const auto floor = [](bool as_phong) {
        SceneBuilder builder;
        PhongMaterial phong;
        phong.diffuse = Vec3(0.6, 0.6, 0.6);
        phong.ambient = Vec3(1, 1, 1);  // meaningless here
        if (as_phong) {
            builder.phong("floor", phong);
        } else {
            builder.diffuse("floor", 0.6);
        }
        builder.object("floor", PlaneShape{}, Vec3(0), "floor");
        builder.sphere("ball", 0.3, Vec3(0, 0, 0.3), "floor").lamp(Vec3(0, 0, 1.5), 0.4, 0.4, 5);
        return seen(builder, DirectStrategy::both, 3);
    };
    const Estimate phong = floor(true);
    const Estimate diffuse = floor(false);
    EXPECT_NEAR(phong.mean, diffuse.mean, 4 * std::hypot(phong.error, diffuse.error));
}

TEST(PhongByPaths, EveryStrategy_HasTheSameMean) {
    SceneBuilder builder;
    PhongMaterial phong;
    phong.diffuse = Vec3(0.4, 0.4, 0.4);
    phong.specular = Vec3(0.4, 0.4, 0.4);
    phong.shininess = 15;
    phong.reflectance = Vec3(0.2, 0.2, 0.2);
    phong.reflectance_spread = 0.3;
    builder.phong("phong", phong).object("floor", PlaneShape{}, Vec3(0), "phong");
    builder.sphere("ball", 0.3, Vec3(0, 0, 0.3), "phong").lamp(Vec3(0, 0, 1.2), 0.5, 0.5, 5);
    const Estimate both = seen(builder, DirectStrategy::both, 2);
    const Estimate lights = seen(builder, DirectStrategy::lights_only, 2);
    const Estimate scattering = seen(builder, DirectStrategy::scattering_only, 2);
    EXPECT_NEAR(lights.mean, both.mean, 4 * std::hypot(lights.error, both.error));
    EXPECT_NEAR(scattering.mean, both.mean, 4 * std::hypot(scattering.error, both.error));
}

// Under a uniform sky a surface that keeps all light and transmits or reflects it is invisible.
TEST(PhongByPaths, GlassThatAbsorbsNothing_IsInvisible) {
    for (const double spread : {0.0, 0.05}) {
        SceneBuilder builder;
        PhongMaterial glass;
        glass.diffuse = Vec3(0, 0, 0);
        glass.reflectance = Vec3(0.3, 0.3, 0.3);
        glass.transmittance = Vec3(0.7, 0.7, 0.7);
        glass.reflectance_spread = spread;
        builder.phong("glass", glass).sphere("ball", 0.5, Vec3(0, 0, 0.3), "glass");
        builder.environment(1);
        PathSettings path;
        path.max_bounces = 40;
        const Estimate mean = test::picture_luminance(
            builder.scene, test::camera(Vec3(0, -3, 0.3), Vec3(0, 0, 0.3), 0.15), path, 16, 16);
        // A spread lobe loses what falls below the surface, which matters only at the rim.
        EXPECT_NEAR(mean.mean, 1, 4 * mean.error + (spread > 0 ? 0.02 : 1e-4)) << spread;
        EXPECT_LE(mean.mean, 1 + 4 * mean.error + 1e-4) << spread;
    }
}

}  // namespace
}  // namespace carom::render
