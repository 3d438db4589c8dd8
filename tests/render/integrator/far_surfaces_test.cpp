// Surfaces whose light is computed once, against the same surfaces followed by paths.
#include <gtest/gtest.h>

#include "core/error.h"
#include "render/frame/bake_far_light.h"
#include "render/threads/thread_arena.h"
#include "tests/render/integrator/integrator_scene.h"

namespace carom::render {
namespace {

using test::camera;
using test::Estimate;
using test::SceneBuilder;

constexpr double kHalfTurn = 3.14159265358979323846;

Mat44 facing(const Vec3& along_x, const Vec3& along_y, const Vec3& at) {
    const Vec3 z = along_x.cross(along_y);
    Mat44 m(along_x.x, along_x.y, along_x.z, 0, along_y.x, along_y.y, along_y.z, 0, z.x, z.y, z.z,
            0, at.x, at.y, at.z, 1);
    return m;
}

/// Adds walls whose fronts are inside, `half` m from the origin. `sides`: of six.
void add_walls(SceneBuilder& builder, double half, int sides = 6) {
    const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    const Vec3 axes[6][2] = {{x, y}, {y, x}, {z, y}, {y, z}, {x, z}, {z, x}};
    for (int side = 0; side < sides; ++side) {
        const Vec3 inwards = axes[side][0].cross(axes[side][1]);
        builder.scene.objects.push_back({"wall " + std::to_string(side),
                                         RectangleShape{Vec2(2 * half, 2 * half)},
                                         facing(axes[side][0], axes[side][1], -half * inwards), "",
                                         side == 0 ? "floor" : "wall"});
    }
}

FarRegion region(int samples) {
    FarRegion far;
    far.low = Vec3(-0.5, -0.5, -0.2);
    far.high = Vec3(0.5, 0.5, 0.2);
    far.distance = 0.6;
    far.cell = 0.25;
    far.cell_growth = 0.1;
    far.samples = samples;
    return far;
}

void add_table(SceneBuilder& builder) {
    builder.diffuse("cloth", 0.7);
    builder.object("table", BoxShape{Vec3(0.8, 0.8, 0.2)}, Vec3(0, 0, 0), "cloth");
}

Estimate seen_from_above(const SceneDescription& scene, DirectStrategy strategy, int samples,
                         int bounces = 8) {
    PathSettings path;
    path.strategy = strategy;
    path.max_bounces = bounces;
    return test::picture_luminance(scene, camera(Vec3(0, 0, 0.7), Vec3(0, 0, 0.1), 0.9), path, 8,
                                   samples);
}

/// In a closed room of one albedo and emission, light is the same everywhere.
TEST(FarSurfaces, WhiteRoom_HasTheRadianceOfAFurnace) {
    SceneBuilder builder;
    StandardMaterial wall;
    wall.base = Vec3(0.5);
    wall.emission = Vec3(1.5);
    builder.material("wall", wall).material("floor", wall);
    add_walls(builder, 2);
    builder.scene.far = region(64);
    const auto light = bake_far_light(builder.scene, {});
    ASSERT_GT(light->cells().size(), 100U);
    for (const FarLight::Cell& cell : light->cells()) {
        ASSERT_NEAR(cell.irradiance.value().x, kHalfTurn * 3, 0.03 * kHalfTurn * 3);
    }
    PathSettings path;
    const Estimate seen = test::picture_luminance(
        builder.scene, camera(Vec3(0, 0, 0), Vec3(1, 0.3, 0.2), 1.5), path, 4, 16);
    EXPECT_NEAR(seen.mean, 3, 0.03);
}

SceneBuilder lamp_room() {
    SceneBuilder builder;
    builder.diffuse("wall", 0.6);
    StandardMaterial floor;
    floor.base = CheckerTexture{Vec3(0.8, 0.4, 0.2), Vec3(0.1, 0.3, 0.5), 0.2, {}};
    builder.material("floor", floor);
    add_walls(builder, 2);
    add_table(builder);
    builder.bulb(Vec3(1.4, 1.2, 1.5), 0.15, 40);
    builder.lamp(Vec3(-1, 0, 1.9), 0.2, 0.3, 15);
    builder.scene.far = region(256);
    return builder;
}

/// The light of the room on the table: what ends on far surfaces has the same mean.
TEST(FarSurfaces, TableInARoom_IsAsBrightAsByPathsAlone) {
    SceneBuilder builder = lamp_room();
    const Estimate baked = seen_from_above(builder.scene, DirectStrategy::both, 64);
    builder.scene.far.reset();
    const Estimate followed = seen_from_above(builder.scene, DirectStrategy::both, 64);
    EXPECT_NEAR(baked.mean, followed.mean, 0.02 * followed.mean);
    EXPECT_GT(followed.mean, 0.1);
}

/// Lamps in the near box are found by scattering, too, and what is beyond it by both.
TEST(FarSurfaces, EveryStrategy_HasTheSameMean) {
    SceneBuilder builder = lamp_room();
    builder.scene.far->samples = 64;
    builder.scene.lights.clear();
    builder.bulb(Vec3(0.6, 0.6, 0.55), 0.12, 20);
    const Estimate both = seen_from_above(builder.scene, DirectStrategy::both, 64, 1);
    const Estimate lights = seen_from_above(builder.scene, DirectStrategy::lights_only, 256, 1);
    const Estimate scattering =
        seen_from_above(builder.scene, DirectStrategy::scattering_only, 1024, 1);
    EXPECT_NEAR(lights.mean, both.mean, 5 * (lights.error + both.error));
    EXPECT_NEAR(scattering.mean, both.mean, 5 * (scattering.error + both.error));
}

/// Two walls are missing: the sky is seen through the gaps.
TEST(FarSurfaces, OpenRoom_IsLitByTheSkyToo) {
    SceneBuilder builder;
    builder.diffuse("wall", 0.6).diffuse("floor", 0.3);
    add_walls(builder, 2, 4);
    add_table(builder);
    builder.environment(0.8);
    builder.scene.far = region(128);
    const Estimate baked = seen_from_above(builder.scene, DirectStrategy::both, 64);
    const Estimate by_lights = seen_from_above(builder.scene, DirectStrategy::lights_only, 256);
    builder.scene.far.reset();
    const Estimate followed = seen_from_above(builder.scene, DirectStrategy::both, 64);
    EXPECT_NEAR(baked.mean, followed.mean, 0.04 * followed.mean);
    EXPECT_NEAR(by_lights.mean, baked.mean, 0.01 * followed.mean);
}

/// Of varnish that is seen, what it reflects is traced; the wood below it has its share.
TEST(FarSurfaces, SeenGloss_IsFollowed) {
    SceneBuilder builder = lamp_room();
    StandardMaterial varnished;
    varnished.base = Vec3(0.3, 0.15, 0.08);
    varnished.coat.weight = 1;
    builder.material("varnished", varnished);
    builder.scene.objects[2].material = "varnished";  // at x = -2
    PathSettings path;
    path.max_bounces = 8;
    const CameraState look = camera(Vec3(0.6, -0.9, 0.4), Vec3(-2, 0.4, 0.2), 0.9);
    const Estimate baked = test::picture_luminance(builder.scene, look, path, 8, 64);
    builder.scene.far.reset();
    const Estimate followed = test::picture_luminance(builder.scene, look, path, 8, 64);
    EXPECT_NEAR(baked.mean, followed.mean, 0.015 * followed.mean);
}

TEST(FarSurfaces, Glass_IsFollowedWhereverItIs) {
    SceneBuilder builder = lamp_room();
    StandardMaterial glass;
    glass.transmission = 1;
    glass.roughness = 0;
    builder.material("glass", glass);
    builder.sphere("bottle", 0.3, Vec3(-1.2, 0.3, 0.2), "glass");
    PathSettings path;
    path.max_bounces = 8;
    const CameraState look = camera(Vec3(0.4, 0, 0.4), Vec3(-1.2, 0.3, 0.2), 0.3);
    const Estimate baked = test::picture_luminance(builder.scene, look, path, 8, 64);
    builder.scene.far.reset();
    const Estimate followed = test::picture_luminance(builder.scene, look, path, 8, 64);
    EXPECT_NEAR(baked.mean, followed.mean, 0.02 * followed.mean);
}

TEST(BakeFarLight, AnyNumberOfThreads_GivesTheSameBytes) {
    SceneBuilder builder = lamp_room();
    builder.scene.far->samples = 4;
    const auto bytes = [&](int threads) {
        return ThreadArena(threads).execute(
            [&] { return encoded(*bake_far_light(builder.scene, {}), ""); });
    };
    const std::string one = bytes(1);
    EXPECT_EQ(one, bytes(2));
    EXPECT_EQ(one, bytes(3));
}

/// Balls and what else moves are not in the light.
TEST(BakeFarLight, WhatFollowsTracks_DoesNotCount) {
    SceneBuilder builder = lamp_room();
    builder.scene.far->samples = 4;
    const std::string without = encoded(*bake_far_light(builder.scene, {}), "");
    builder.scene.objects.insert(builder.scene.objects.begin(),
                                 {"ball", SphereShape{0.2}, Mat44(), "ball", "cloth"});
    EXPECT_EQ(without, encoded(*bake_far_light(builder.scene, {}), ""));
}

TEST(BakeFarLight, ProgressGrowsToOne_AndAStopIsObeyed) {
    SceneBuilder builder = lamp_room();
    builder.scene.far->samples = 4;
    double last = 0;
    const auto progress = [&](double done) {
        EXPECT_GE(done, last);
        last = done;
    };
    static_cast<void>(bake_far_light(builder.scene, {progress, {}}));
    EXPECT_EQ(last, 1);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(static_cast<void>(bake_far_light(builder.scene, {{}, stop.get_token()})), Stopped);
}

}  // namespace
}  // namespace carom::render
