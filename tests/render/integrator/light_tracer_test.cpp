#include "render/integrator/light_tracer.h"

#include <gtest/gtest.h>

#include "tests/render/integrator/integrator_scene.h"

namespace carom::render {
namespace {

using test::Estimate;
using test::SceneBuilder;

constexpr int kSize = 16;

/// Two smooth balls, one coated and one of polished metal, and a third ball that occludes some of
/// their reflections.
SceneBuilder balls() {
    SceneBuilder builder;
    StandardMaterial phenolic;
    phenolic.base = Vec3(0.02, 0.02, 0.02);
    phenolic.coat = {1, 1.8, 0};
    StandardMaterial chalk;
    chalk.base = Vec3(0.1, 0.1, 0.1);
    StandardMaterial metal;
    metal.base = Vec3(0.12, 0.1, 0.08);
    metal.metal = 1;
    metal.roughness = 0;
    builder.material("phenolic", phenolic).material("metal", metal).material("chalk", chalk);
    builder.sphere("a", 0.3, Vec3(-0.4, 0, 0.3), "phenolic");
    builder.sphere("b", 0.2, Vec3(0.35, 0.2, 0.2), "metal");
    builder.sphere("c", 0.1, Vec3(0.12, -0.3, 0.3), "chalk");
    return builder;
}

/// With a bulb and a small lamp that both balls reflect.
SceneBuilder balls_before_lights() {
    return balls().bulb(Vec3(-1.2, -1.8, 1.5), 0.25, 60).lamp(Vec3(0.4, -0.9, 2), 0.3, 0.2, 40);
}

/// With a lens that spreads the images over the picture.
CameraState camera() {
    CameraState state = test::camera(Vec3(0, -2.6, 0.9), Vec3(0, 0.1, 0.25), 0.5);
    state.lens_radius = 0.06;
    state.focus_distance = 1.6;
    return state;
}

/// Mean luminance of the picture, with the reflections of lights by light tracing or by chance.
Estimate seen(const PreparedScene& prepared, bool splats, int runs, int samples,
              const CameraState& state = camera()) {
    const auto& data = prepared.data();
    const FrameScene frame(data.geometry, {}, 0, 0);
    const TransportScene scene{frame, data.materials, data.lights, data.object_count};
    const ThinLensCamera lens(state, state, kSize, kSize, 0, PixelFilter::box, 1);
    const LightTracer tracer(scene, lens);
    PathSettings path;
    path.max_bounces = 1;
    const PathIntegrator integrator(scene, path, splats ? &tracer : nullptr);
    EXPECT_EQ(tracer.pair_count(),
              2 * data.lights.area_light_count() + 2 * data.lights.is_delta(0));
    const auto workspace = integrator.make_workspace();
    std::vector<double> means;
    for (int run = 0; run < runs; ++run) {
        const auto seed = static_cast<std::uint64_t>(run);
        RenderStatistics count;
        double sum = 0;
        test::for_each_sample(integrator, lens, {kSize, kSize, samples, seed}, workspace.get(),
                              [&](const SampleIndex&, const RadianceSample& result) {
                                  sum += static_cast<double>(luminance(result.radiance)) / samples;
                              });
        for (std::size_t pair = 0; splats && pair < tracer.pair_count(); ++pair) {
            for (const Splat& splat : tracer.splats(pair, samples, seed, count)) {
                const bool inside = splat.position.x >= 0 && splat.position.x < kSize &&
                                    splat.position.y >= 0 && splat.position.y < kSize;
                sum += inside ? static_cast<double>(luminance(splat.flux)) : 0;
            }
        }
        means.push_back(sum / (kSize * kSize));
    }
    return test::estimate_of(means);
}

TEST(LightTracer, SampledOrFoundByChance_HaveTheSameMean) {
    const PreparedScene prepared(balls_before_lights().scene,
                                 test::small_settings(kSize, kSize, 16));
    const Estimate sampled = seen(prepared, true, 24, 16);
    const Estimate by_chance = seen(prepared, false, 48, 256);
    EXPECT_NEAR(sampled.mean, by_chance.mean, 4 * std::hypot(sampled.error, by_chance.error));
    EXPECT_LT(by_chance.error, 0.01 * by_chance.mean);
    // With a thirty-second of the samples.
    EXPECT_LT(sampled.error, by_chance.error);
}

TEST(LightTracer, ThroughAShapedLens_HasTheSameMean) {
    const PreparedScene prepared(balls_before_lights().scene,
                                 test::small_settings(kSize, kSize, 16));
    CameraState state = camera();
    state.lens = LensShape{1.05, 0.9, 0.5, -0.15};
    const Estimate sampled = seen(prepared, true, 24, 16, state);
    const Estimate by_chance = seen(prepared, false, 48, 256, state);
    EXPECT_NEAR(sampled.mean, by_chance.mean, 4 * std::hypot(sampled.error, by_chance.error));
    EXPECT_LT(by_chance.error, 0.02 * by_chance.mean);
    EXPECT_LT(sampled.mean, 0.97 * seen(prepared, true, 24, 16).mean) << "the corners are darker";
}

TEST(LightTracer, OfAPoint_AreThoseOfASmallBulb) {
    const Vec3 place(-1.2, -1.8, 1.5);
    constexpr double kRadius = 0.01;
    SceneBuilder point = balls();
    point.scene.lights.push_back({"point", PointLight{place, Vec3(10)}});
    const double radiance = 10 / (M_PI * kRadius * kRadius);
    const RenderSettings settings = test::small_settings(kSize, kSize, 16);
    const Estimate of_point = seen(PreparedScene(point.scene, settings), true, 24, 16);
    const Estimate of_bulb =
        seen(PreparedScene(balls().bulb(place, kRadius, radiance).scene, settings), true, 24, 16);
    EXPECT_NEAR(of_point.mean, of_bulb.mean, 4 * std::hypot(of_point.error, of_bulb.error));
    EXPECT_LT(of_bulb.error, 0.002 * of_bulb.mean);
}

}  // namespace
}  // namespace carom::render
