#include "render/integrator/caustics.h"

#include <gtest/gtest.h>

#include "tests/render/integrator/integrator_scene.h"

namespace carom::render {
namespace {

using test::Estimate;
using test::SceneBuilder;

/// Smooth coated balls on a floor with a wide highlight; a lamp and a bulb
/// near enough that what the balls mirror onto the floor is a good part of what is seen there.
SceneBuilder mirrors_on_floor() {
    SceneBuilder builder;
    StandardMaterial phenolic;
    phenolic.base = Vec3(0.02, 0.02, 0.02);
    phenolic.coat = {1, 2.5, 0};
    StandardMaterial floor;
    floor.base = Vec3(0.5, 0.5, 0.5);
    floor.specular = 0.5;
    floor.roughness = 0.6;
    builder.material("phenolic", phenolic).material("floor", floor);
    builder.object("floor", PlaneShape{}, Vec3(0, 0, 0), "floor");
    builder.sphere("a", 0.3, Vec3(-0.4, 0, 0.3), "phenolic");
    builder.sphere("b", 0.2, Vec3(0.35, 0.2, 0.2), "phenolic");
    builder.lamp(Vec3(0.9, -0.4, 1), 0.15, 0.1, 40).bulb(Vec3(-1.2, -0.8, 0.5), 0.12, 60);
    return builder;
}

Estimate seen(bool caustics, int bounces) {
    PathSettings path;
    path.caustics = caustics;
    path.max_bounces = bounces;
    // Between the balls, in the shadow of the one and beside the other.
    return test::picture_luminance(mirrors_on_floor().scene,
                                   test::camera(Vec3(0, -1.6, 1.4), Vec3(0, -0.05, 0), 0.35), path,
                                   32, 64);
}

TEST(Caustics, SoughtOrFoundByChance_HaveTheSameMean) {
    for (const int bounces : {1, 3}) {
        const Estimate sought = seen(true, bounces);
        const Estimate by_chance = seen(false, bounces);
        EXPECT_NEAR(sought.mean, by_chance.mean, 4 * std::hypot(sought.error, by_chance.error))
            << bounces;
        EXPECT_LT(sought.error, 0.7 * by_chance.error) << bounces;
        EXPECT_LT(by_chance.error, 0.01 * by_chance.mean) << bounces;
    }
}

TEST(Caustics, AddLight) {
    // Without a bounce there is no way by a mirror: what is sought must respect the limit.
    EXPECT_EQ(seen(true, 0).mean, seen(false, 0).mean);
    const double without = seen(true, 0).mean;
    EXPECT_GT(seen(true, 1).mean, 1.02 * without);
}

}  // namespace
}  // namespace carom::render
