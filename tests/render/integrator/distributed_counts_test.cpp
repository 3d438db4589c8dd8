// Numbers of rays by kind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/integrator/distributed_ray_counts.h"
#include "tests/render/integrator/distributed_scene.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

using test::DistributedScene;
using test::grey;
using test::SceneBuilder;
using test::Traced;

DistributedSettings many() {
    DistributedSettings settings;
    settings.shadow_samples = 4;
    settings.reflection_samples = 2;
    settings.refraction_samples = 3;
    settings.recursion_limit = 2;
    settings.falloff = false;
    return settings;
}

/// Nested boxes, so that two generations of refraction do not lead outside, with the index of air,
/// so that nothing reflects totally; and two lights that no ray hits.
DistributedScene boxes_in_boxes() {
    PhongMaterial both;
    both.reflectance = both.transmittance = grey(0.3);
    both.reflectance_spread = 0.4;
    both.transmittance_spread = 0.4;
    both.index = 1;
    SceneBuilder builder;
    builder.phong("both", both);
    for (const double size : {1.0, 2.0, 4.0}) {
        builder.object("box" + std::to_string(size), BoxShape{grey(size)}, Vec3(0), "both");
    }
    builder.lamp(Vec3(0, 0, 5), 1, 1, 10).bulb(Vec3(5, 5, 5), 1, 10);
    return DistributedScene(builder.scene);
}

RenderStatistics sum_of(const DistributedScene& scene, const DistributedSettings& settings,
                        int rays) {
    RenderStatistics sum;
    test::TestRandom random(3);
    for (int i = 0; i < rays; ++i) {
        const double x = static_cast<double>(random.between(-1, 1));
        const double y = static_cast<double>(random.between(-1, 1));
        const double z = static_cast<double>(random.between(-1, 1));
        sum += scene
                   .trace(settings, Vec3(0.1, 0.2, -0.1), Vec3(x, y, z + 1e-3),
                          static_cast<std::uint32_t>(i))
                   .count;
    }
    return sum;
}

TEST(RayCounts, InAClosedScene_AreThoseOfTheFormula) {
    // 1 + 5 + 25 rays, each with 2 x 4 shadow rays.
    const RenderStatistics count = sum_of(boxes_in_boxes(), many(), 200);
    EXPECT_EQ(count.camera_rays, 200u);
    EXPECT_EQ(count.reflection_rays, 200u * (1 + 5) * 2);
    EXPECT_EQ(count.refraction_rays, 200u * (1 + 5) * 3);
    EXPECT_EQ(count.scattered_rays, 200u * 30);
    EXPECT_EQ(count.shadow_rays, 200u * 31 * 8);
    EXPECT_LT(count.needless_shadow_rays, count.shadow_rays);
    EXPECT_EQ(rays_per_camera_ray(many(), 2), 31 * 9);
}

TEST(RayCounts, WithFallOff_HalveWithEachGeneration) {
    // Shadow samples 4, 2, 1; reflection 2, 1; refraction 3, 2: 1 + 5 + 15 rays.
    DistributedSettings settings = many();
    settings.falloff = true;
    const RenderStatistics count = sum_of(boxes_in_boxes(), settings, 200);
    EXPECT_EQ(count.reflection_rays, 200u * (2 + 5 * 1));
    EXPECT_EQ(count.refraction_rays, 200u * (3 + 5 * 2));
    EXPECT_EQ(count.shadow_rays, 200u * 2 * (4 + 5 * 2 + 15));
    EXPECT_EQ(rays_per_camera_ray(settings, 2), 9 + 5 * 5 + 15 * 3);
}

TEST(RayCounts, OfZero_SendNoSuchRays) {
    DistributedSettings settings = many();
    settings.refraction_samples = 0;
    RenderStatistics count = sum_of(boxes_in_boxes(), settings, 200);
    EXPECT_EQ(count.refraction_rays, 0u);
    EXPECT_EQ(count.scattered_rays, 200u * (2 + 4));
    EXPECT_EQ(rays_per_camera_ray(settings, 2), (1 + 2 + 4) * 9);
    settings = many();
    settings.reflection_samples = 0;
    settings.falloff = true;
    count = sum_of(boxes_in_boxes(), settings, 200);
    EXPECT_EQ(count.reflection_rays, 0u);
    EXPECT_EQ(count.refraction_rays, 200u * (3 + 3 * 2));  // halved
}

TEST(RayCounts, WithoutSpread_OneRayIsEnough) {
    PhongMaterial mirror;
    mirror.reflectance = grey(0.5);
    SceneBuilder builder;
    builder.phong("mirror", mirror).sphere("room", 1, Vec3(0), "mirror").environment(1);
    DistributedSettings settings = many();
    settings.reflection_samples = 16;
    const Traced traced =
        DistributedScene(builder.scene).trace(settings, Vec3(0), Vec3(1, 0.2, 0.1));
    EXPECT_EQ(traced.count.reflection_rays, 2u);
}

TEST(RayCounts, SamplesAtADepth_NeverFallBelowOne) {
    EXPECT_EQ(samples_at(7, 0, true), 7);
    EXPECT_EQ(samples_at(7, 1, true), 4);
    EXPECT_EQ(samples_at(7, 2, true), 2);
    EXPECT_EQ(samples_at(7, 32, true), 1);
    EXPECT_EQ(samples_at(7, 32, false), 7);
}

TEST(RayCounts, ClassicFormula_GivesTheTablesOfItsText) {
    // Table 2 of the text: 800 x 600, two lights; blur, lens, shadow, reflection, refraction,
    // recursion.
    const auto rays = [](int blur, int lens, int shadow, int reflection, int refraction,
                         int limit) {
        DistributedSettings settings;
        settings.blur_samples = blur;
        settings.lens_samples = lens;
        settings.shadow_samples = shadow;
        settings.reflection_samples = reflection;
        settings.refraction_samples = refraction;
        settings.recursion_limit = limit;
        return 800.0 * 600.0 * rays_by_classic_formula(settings, 2);
    };
    EXPECT_NEAR(rays(32, 18, 2, 2, 0, 1), 5.5e9, 0.05e9);
    EXPECT_NEAR(rays(32, 18, 2, 2, 0, 2), 15e9, 1e9);
    EXPECT_NEAR(rays(100, 100, 2, 1, 0, 1), 57e9, 1e9);
    EXPECT_NEAR(rays(100, 100, 2, 2, 0, 2), 249e9, 1e9);
    EXPECT_NEAR(rays(100, 100, 8, 4, 4, 2), 11e12, 0.2e12);
}

TEST(RayCounts, ClassicFormulaWithoutDistribution_GivesTheTableOfItsText) {
    // Table 1 of the text: 800 x 600, two lights.
    const auto rays = [](int limit) { return 800.0 * 600.0 * rays_without_distribution(limit, 2); };
    EXPECT_NEAR(rays(2), 6e6, 0.3e6);
    EXPECT_NEAR(rays(10), 2e9, 0.1e9);
    EXPECT_NEAR(rays(20), 2e12, 0.1e12);
    RenderStatistics count;
    count.camera_rays = 800 * 600 * 4;
    RenderSettings settings;
    settings.distributed = test::whitted(2);
    settings.distributed.pixel_samples = 4;
    EXPECT_EQ(describe_rays(count, settings, 2).back(),
              "by the classic formula without distribution: 5.76e+06 = pixels x 2 L (2^2 - 1); the "
              "camera rays are the first generation");
}

TEST(RayCounts, AsText_StandBesideBothFormulas) {
    RenderStatistics count;
    count.camera_rays = 100;
    count.reflection_rays = 20;
    count.refraction_rays = 10;
    count.scattered_rays = 30;
    count.shadow_rays = 1040;
    count.needless_shadow_rays = 4;
    RenderSettings settings;
    settings.width = 10;
    settings.height = 10;
    settings.distributed = many();
    settings.distributed.pixel_samples = settings.distributed.blur_samples = 1;
    settings.distributed.lens_samples = 1;
    const std::vector<std::string> text = describe_rays(count, settings, 2);
    ASSERT_EQ(text.size(), 6u);
    EXPECT_EQ(text[0], "rays: 1170 = 100 camera + 20 reflection + 10 refraction + 1040 shadow");
    EXPECT_THAT(text[1], testing::HasSubstr("4 were dark"));
    EXPECT_THAT(text[2], testing::HasSubstr("2.79e+04 = camera rays"));
    // 100 pixels, each 8 + 2 x 8 x (5 + 25).
    EXPECT_THAT(text[4], testing::HasSubstr("4.88e+04 = pixels"));
}

}  // namespace
}  // namespace carom::render
