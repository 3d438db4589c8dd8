#include <cmath>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "render/integrator/scalar_kernels.h"
#include "tests/render/integrator/integrator_scene.h"
#include "tests/scratch_folder.h"

namespace carom::render {
namespace {

using test::Estimate;
using test::SceneBuilder;

/// Balls with every kind of lobe on a floor, and two area lights.
SceneBuilder balls_on_floor() {
    SceneBuilder builder;
    StandardMaterial lacquer;
    lacquer.base = Vec3(0.6, 0.3, 0.2);
    lacquer.coat = {1, 1.5, 0.5};
    StandardMaterial metal;
    metal.base = Vec3(0.9, 0.7, 0.4);
    metal.metal = 1;
    metal.roughness = 0.55;
    StandardMaterial cloth;
    cloth.base = Vec3(0.2, 0.5, 0.3);
    cloth.sheen = 0.5;
    cloth.specular = 0.5;
    cloth.roughness = 0.7;
    builder.material("lacquer", lacquer).material("metal", metal).material("cloth", cloth);
    builder.object("floor", PlaneShape{}, Vec3(0, 0, 0), "cloth");
    builder.sphere("a", 0.3, Vec3(-0.3, 0, 0.3), "lacquer");
    builder.sphere("b", 0.25, Vec3(0.3, 0.1, 0.25), "metal");
    builder.lamp(Vec3(0, 0, 1.4), 0.6, 0.5, 6).bulb(Vec3(0.9, -0.4, 0.8), 0.25, 8);
    builder.environment(0.05);
    return builder;
}

Estimate with(DirectStrategy strategy, int bounces) {
    PathSettings path;
    path.strategy = strategy;
    path.max_bounces = bounces;
    return test::picture_luminance(balls_on_floor().scene,
                                   test::camera(Vec3(0, -2.2, 1), Vec3(0, 0, 0.25), 0.6), path, 24,
                                   16);
}

TEST(DirectLight, EveryStrategy_HasTheSameMean) {
    for (const int bounces : {0, 2}) {
        const Estimate both = with(DirectStrategy::both, bounces);
        const Estimate lights = with(DirectStrategy::lights_only, bounces);
        const Estimate scattering = with(DirectStrategy::scattering_only, bounces);
        EXPECT_NEAR(lights.mean, both.mean, 4 * std::hypot(lights.error, both.error)) << bounces;
        EXPECT_NEAR(scattering.mean, both.mean, 4 * std::hypot(scattering.error, both.error))
            << bounces;
        EXPECT_LT(both.error, 0.01 * both.mean);
        EXPECT_LT(scattering.error, 0.02 * both.mean);
    }
}

// Lights in front of and behind the glass, and the floor seen through it.
TEST(DirectLight, FrostedGlass_EveryStrategyHasTheSameMean) {
    StandardMaterial frosted;
    frosted.transmission = 1;
    frosted.roughness = 0.5;
    SceneBuilder builder = balls_on_floor();
    builder.material("frosted", frosted);
    builder.sphere("c", 0.3, Vec3(0, -0.6, 0.35), "frosted");
    const auto of = [&](DirectStrategy strategy) {
        PathSettings path;
        path.strategy = strategy;
        path.max_bounces = 4;
        return test::picture_luminance(builder.scene,
                                       test::camera(Vec3(0, -2.2, 0.6), Vec3(0, -0.6, 0.35), 0.3),
                                       path, 24, 96);
    };
    const Estimate both = of(DirectStrategy::both);
    const Estimate lights = of(DirectStrategy::lights_only);
    const Estimate scattering = of(DirectStrategy::scattering_only);
    EXPECT_NEAR(lights.mean, both.mean, 4 * std::hypot(lights.error, both.error));
    EXPECT_NEAR(scattering.mean, both.mean, 4 * std::hypot(scattering.error, both.error));
    EXPECT_LT(both.error, 0.02 * both.mean);
}

// Lamps whose radiance depends on place and direction; the smooth ball shows them and reflects
// their light onto the floor.
TEST(DirectLight, DisksAndShades_EveryStrategyHasTheSameMean) {
    SceneBuilder builder = balls_on_floor();
    builder.scene.lights.clear();
    render::DiskLight disk;
    disk.centre = Vec3(0.7, 0.3, 0.9);
    disk.radius = 0.3;
    disk.radiance = Vec3(6, 6, 6);
    disk.beam = 3;
    render::ShadeLight shade;
    shade.centre = Vec3(-0.2, 0, 1);
    shade.normal = Vec3(0, -0.28, -0.96);
    shade.shape = {0.4, 0.1, 0.4, 0.5};
    shade.disk_radius = 0.2;
    shade.depth = 0.25;
    shade.radiance = Vec3(15, 15, 15);
    builder.scene.lights.push_back({"disk", disk});
    builder.scene.lights.push_back({"shade", shade});
    const auto of = [&](DirectStrategy strategy) {
        PathSettings path;
        path.strategy = strategy;
        path.max_bounces = 2;
        return test::picture_luminance(
            builder.scene, test::camera(Vec3(0, -2.2, 1), Vec3(0, 0, 0.25), 0.6), path, 24, 64);
    };
    const Estimate both = of(DirectStrategy::both);
    const Estimate lights = of(DirectStrategy::lights_only);
    const Estimate scattering = of(DirectStrategy::scattering_only);
    EXPECT_NEAR(lights.mean, both.mean, 4 * std::hypot(lights.error, both.error));
    EXPECT_NEAR(scattering.mean, both.mean, 4 * std::hypot(scattering.error, both.error));
    EXPECT_LT(both.error, 0.01 * both.mean);
    EXPECT_LT(scattering.error, 0.02 * both.mean);
}

TEST(DirectLight, Together_TheyBeatEitherAlone) {
    const Estimate both = with(DirectStrategy::both, 0);
    EXPECT_LT(both.error, 1.1 * with(DirectStrategy::lights_only, 0).error);
    EXPECT_LT(both.error, with(DirectStrategy::scattering_only, 0).error);
}

/// A picture of a dim sky with a brighter patch, in its own file.
class SkyPicture {
  public:
    SkyPicture() {
        std::vector<float> pixels;
        for (int i = 0; i < kWidth * kHeight; ++i) {
            const bool patch = i % kWidth > 8 && i % kWidth < 12 && i / kWidth == 2;
            pixels.insert(pixels.end(), 3, patch ? 4.0f : 0.1f);
        }
        const auto file = OIIO::ImageOutput::create(path_);
        file->open(path_, OIIO::ImageSpec(kWidth, kHeight, 3, OIIO::TypeDesc::FLOAT));
        file->write_image(OIIO::TypeDesc::FLOAT, pixels.data());
        file->close();
    }
    SkyPicture(const SkyPicture&) = delete;
    SkyPicture& operator=(const SkyPicture&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }

  private:
    static constexpr int kWidth = 16;
    static constexpr int kHeight = 8;
    carom::testing::ScratchFolder folder_;
    std::string path_ = folder_.path("sky.exr");
};

// The lamp has a thousand times the importance of the sky, which is thus sampled at one vertex in
// eight. A screen occludes the lamp, so that the whole picture depends on these few samples.
TEST(DirectLight, DimSkyBesideABrightLamp_EveryStrategyHasTheSameMean) {
    const SkyPicture sky;
    SceneBuilder builder = balls_on_floor();
    builder.scene.lights.clear();
    builder.object("screen", render::BoxShape{Vec3(0.5, 0.5, 0.01)}, Vec3(0, 0, 2.9), "metal");
    builder.lamp(Vec3(0, 0, 3), 0.2, 0.2, 2000);
    EnvironmentLight light;
    light.image = sky.path();
    builder.scene.lights.push_back({"sky", light});
    const auto of = [&](DirectStrategy strategy) {
        PathSettings path;
        path.strategy = strategy;
        path.max_bounces = 0;
        return test::picture_luminance(
            builder.scene, test::camera(Vec3(0, -1.2, 1.2), Vec3(0, 0, 0.2), 0.6), path, 24, 64);
    };
    const Estimate both = of(DirectStrategy::both);
    const Estimate lights = of(DirectStrategy::lights_only);
    const Estimate scattering = of(DirectStrategy::scattering_only);
    EXPECT_NEAR(lights.mean, both.mean, 4 * std::hypot(lights.error, both.error));
    EXPECT_NEAR(scattering.mean, both.mean, 4 * std::hypot(scattering.error, both.error));
    EXPECT_LT(both.error, 0.01 * both.mean);
    EXPECT_LT(lights.error, 0.02 * both.mean);
    EXPECT_LT(scattering.error, 0.02 * both.mean);
}

TEST(PowerHeuristic, BothWeights_AddUpToOne) {
    const auto power_heuristic = [](float pdf, float other) {
        return scalar::power_heuristic<scalar::One>(pdf, other);
    };
    EXPECT_FLOAT_EQ(power_heuristic(2, 3) + power_heuristic(3, 2), 1);
    EXPECT_EQ(power_heuristic(1, 0), 1);
    EXPECT_LT(power_heuristic(1e-20f, 1e20f), 1e-6f);
}

}  // namespace
}  // namespace carom::render
