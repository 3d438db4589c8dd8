// The results of waves depend neither on the width of the vectors nor on the samples in a wave.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "tests/render/integrator/wave_cases.h"

namespace carom::test {
namespace {

using render::CameraBatch;
using render::CameraRun;
using render::RadianceSample;

constexpr int kSide = 24;  // pixels
constexpr int kSamples = 4;
constexpr float kRounding = 1e-6f;  // a few units in the last place
constexpr std::int64_t kAllButOneLane = ~std::int64_t{HWY_SCALAR | HWY_EMU128};

bool is_near(const render::V3f& a, const render::V3f& b) {
    return (a - b).length() <= kRounding * (a.length() + b.length());
}

/// What rays that end at what they see find.
std::vector<RadianceSample> sights_of(const render::Integrator& integrator,
                                      const std::vector<CameraBatch>& batches, float spread) {
    std::vector<RadianceSample> seen(batches.size() * CameraBatch::kUsual);
    const auto workspace = integrator.make_workspace();
    std::size_t first = 0;
    for (const CameraBatch& batch : batches) {
        integrator.trace_first_hits(CameraRun::all(batch), spread, &seen[first], workspace.get());
        first += static_cast<std::size_t>(batch.count);
    }
    seen.resize(first);
    return seen;
}

/// They find the same as the samples. A rough coat shows a sample another part of its surroundings,
/// in the mean the same.
void expect_same_sights(const std::vector<RadianceSample>& seen,
                        const std::vector<RadianceSample>& samples) {
    render::V3f sum(0, 0, 0);
    float squares = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        EXPECT_EQ(seen[i].object, samples[i].object) << i;
        EXPECT_EQ(seen[i].coverage, samples[i].coverage) << i;
        EXPECT_EQ(seen[i].normal, samples[i].normal) << i;
        EXPECT_EQ(seen[i].albedo, samples[i].albedo) << i;
        EXPECT_TRUE(is_near(seen[i].light, samples[i].light)) << i;
        const render::V3f difference = seen[i].mirrored - samples[i].mirrored;
        sum += difference;
        squares += difference.length2();
    }
    EXPECT_LE(sum.length(), 4 * std::sqrt(squares) + 1e-4f);
}

void expect_same_bits(const std::vector<RadianceSample>& a, const std::vector<RadianceSample>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].radiance, b[i].radiance) << i;
        EXPECT_EQ(a[i].coverage, b[i].coverage) << i;
        EXPECT_EQ(a[i].normal, b[i].normal) << i;
        EXPECT_EQ(a[i].albedo, b[i].albedo) << i;
        EXPECT_EQ(a[i].mirrored, b[i].mirrored) << i;
        EXPECT_EQ(a[i].light, b[i].light) << i;
        EXPECT_EQ(a[i].object, b[i].object) << i;
    }
}

std::vector<RadianceSample> samples_of(const render::Integrator& integrator,
                                       const std::vector<CameraBatch>& batches, float spread,
                                       render::RenderStatistics& count) {
    std::vector<RadianceSample> results(batches.size() * CameraBatch::kUsual);
    const auto workspace = integrator.make_workspace();
    std::size_t first = 0;
    for (const CameraBatch& batch : batches) {
        integrator.samples(CameraRun::all(batch), spread, &results[first], workspace.get(), count);
        first += static_cast<std::size_t>(batch.count);
    }
    results.resize(first);
    return results;
}

/// Samples of all pixels with their rays.
std::vector<CameraBatch> batches_of(const render::ThinLensCamera& lens, int samples,
                                    int room = CameraBatch::kUsual) {
    std::vector<CameraBatch> batches;
    for (int i = 0; i < kSide * kSide * samples; ++i) {
        if (batches.empty() || batches.back().count == room) {
            batches.emplace_back(room);
        }
        const int x = i / samples % kSide;
        const int y = i / samples / kSide;
        const render::SampleStream stream(3, static_cast<std::uint32_t>(x),
                                          static_cast<std::uint32_t>(y),
                                          static_cast<std::uint32_t>(i % samples));
        batches.back().add(stream, {x, y, i % samples});
    }
    for (CameraBatch& batch : batches) {
        render::make_rays(lens, {}, batch);
    }
    return batches;
}

class Waves : public testing::TestWithParam<WaveCase> {};

TEST_P(Waves, OneLaneOrMany_GiveTheSameBits) {
    SceneBuilder builder;
    add_table(builder);
    GetParam().furnish(builder);
    const render::RenderSettings settings = small_settings(kSide, kSide, kSamples);
    const render::PreparedScene prepared(builder.scene, settings);
    const auto& data = prepared.data();
    const std::vector<sim::Track> tracks = table_tracks();
    const render::FrameScene frame(data.geometry, tracks, 0, kWaveShutter);
    const render::LightSet lights = data.lights.in_frame(frame.motions());
    const render::TransportScene scene{frame, data.materials, lights, data.object_count};
    const render::CameraState state = camera(Vec3(0.3, -1.6, 1.1), Vec3(0, 0, 0.05), 0.8);
    const render::ThinLensCamera lens(state, state, kSide, kSide, 0, render::PixelFilter::box, 1);
    const render::LightTracer light_tracer(scene, lens);
    const std::vector<CameraBatch> batches = batches_of(lens, kSamples);
    const float spread = lens.frame_at(0).pixel_size;

    const render::PathIntegrator many(scene, GetParam().path, &light_tracer);
    render::RenderStatistics count;
    const std::vector<RadianceSample> samples = samples_of(many, batches, spread, count);
    const std::vector<RadianceSample> seen = sights_of(many, batches, spread);
    expect_same_sights(seen, samples);

    hwy::DisableTargets(kAllButOneLane);
    const render::PathIntegrator one(scene, GetParam().path, &light_tracer);
    hwy::DisableTargets(0);
    render::RenderStatistics count_of_one;
    expect_same_bits(samples_of(one, batches, spread, count_of_one), samples);
    expect_same_bits(sights_of(one, batches, spread), seen);
    EXPECT_EQ(count.camera_rays, count_of_one.camera_rays);
    EXPECT_EQ(count.scattered_rays, count_of_one.scattered_rays);
    EXPECT_EQ(count.shadow_rays, count_of_one.shadow_rays);
}

INSTANTIATE_TEST_SUITE_P(All, Waves, testing::ValuesIn(wave_cases()),
                         [](const auto& tested) { return tested.param.name; });

// A sample must not depend on those traced with it: frames do not depend on tiles and chunks.
TEST(PathIntegrator, Samples_DoNotDependOnOthersInTheWave) {
    SceneBuilder builder;
    add_table(builder);
    add_lights(builder);
    const render::RenderSettings settings = small_settings(kSide, kSide, 1);
    const render::PreparedScene prepared(builder.scene, settings);
    const auto& data = prepared.data();
    const std::vector<sim::Track> tracks = table_tracks();
    const render::FrameScene frame(data.geometry, tracks, 0, kWaveShutter);
    const render::LightSet lights = data.lights.in_frame(frame.motions());
    const render::TransportScene scene{frame, data.materials, lights, data.object_count};
    const render::CameraState state = camera(Vec3(0.3, -1.6, 1.1), Vec3(0, 0, 0.05), 0.8);
    const render::ThinLensCamera lens(state, state, kSide, kSide, 0, render::PixelFilter::box, 1);
    const auto traced = [&](int at_once, int wave_samples, int room = CameraBatch::kUsual) {
        const std::vector<CameraBatch> batches = batches_of(lens, 1, room);
        const render::PathIntegrator many(scene, {}, nullptr, wave_samples);
        std::vector<RadianceSample> results(std::size_t{kSide} * kSide);
        RadianceSample* result = results.data();
        render::RenderStatistics count;
        const auto workspace = many.make_workspace();
        for (const CameraBatch& batch : batches) {
            for (int from = 0; from < batch.count; from += at_once) {
                const CameraRun run = CameraRun::all(batch).part(from, at_once);
                many.samples(run, 0.001f, result, workspace.get(), count);
                result += run.count;
            }
        }
        return results;
    };
    const std::vector<RadianceSample> whole = traced(CameraBatch::kUsual, render::kWaveSamples);
    const auto expect_same = [&](int at_once, int wave_samples, int room = CameraBatch::kUsual) {
        const std::vector<RadianceSample> parts = traced(at_once, wave_samples, room);
        for (std::size_t i = 0; i < whole.size(); ++i) {
            ASSERT_EQ(whole[i].radiance, parts[i].radiance)
                << at_once << " " << wave_samples << " " << i;
        }
    };
    for (const int at_once : {1, 7, 100}) {
        expect_same(at_once, render::kWaveSamples);
    }
    for (const int wave_samples : {1, 3}) {
        expect_same(CameraBatch::kUsual, wave_samples);
    }
    expect_same(2000, 2000, 2000);
}

std::vector<float> small_picture() {
    SceneBuilder builder;
    add_table(builder);
    add_lights(builder);
    add_mixed_materials(builder);
    const render::RenderSettings settings = small_settings(kSide, kSide, 16);
    const render::PreparedScene prepared(builder.scene, settings);
    render::FrameInput frame = static_frame(camera(Vec3(0.3, -1.6, 1.1), Vec3(0, 0, 0.05), 0.8));
    frame.scene_close = kWaveShutter;
    return render::render_frame(prepared, table_tracks(), frame, settings).rgba;
}

// A frame's key in the store does not contain the vector width.
TEST(PathIntegrator, WiderVectors_GiveTheSameBits) {
    const std::int64_t targets = hwy::SupportedTargets();
    constexpr std::int64_t kWider = HWY_AVX3 | HWY_AVX3_DL;
    if ((targets & kWider) == 0) {
        GTEST_SKIP() << "this processor has none";
    }
    const std::vector<float> wide = small_picture();
    hwy::DisableTargets(kWider);
    const std::vector<float> narrow = small_picture();
    hwy::DisableTargets(0);
    EXPECT_EQ(wide, narrow);
}

}  // namespace
}  // namespace carom::test
