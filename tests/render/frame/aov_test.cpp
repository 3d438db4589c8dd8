#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "core/hash.h"
#include "render/frame/aov_planes.h"
#include "tests/render/frame/table_scene.h"
#include "tests/render/scene_builder.h"

namespace carom::render {
namespace {

using test::camera;
using test::plane;
using test::SceneBuilder;
using test::small_settings;
using test::static_frame;

RenderSettings with_all_aovs(int samples) {
    RenderSettings settings = small_settings(32, 18, samples);
    settings.aovs = {"depth", "normal", "albedo", "motion", "object_id", "variance"};
    return settings;
}

/// Coverage of a name in the mattes of a pixel, and the sum over all names.
double coverage(const Film& film, const std::string& layer, std::size_t pixel,
                const std::string& name = "") {
    double sum = 0;
    const std::vector<std::string> channels = matte_channels(layer);
    for (std::size_t i = 0; i < channels.size(); i += 2) {
        const float id = plane(film, channels[i])[pixel];
        const float fraction = plane(film, channels[i + 1])[pixel];
        if (name.empty() || id == matte_id(name)) {
            sum += static_cast<double>(fraction);
        }
    }
    return sum;
}

/// A wall 2 m ahead, a small box in front of it at 1.5 m.
SceneBuilder wall_and_box() {
    SceneBuilder builder;
    builder.diffuse("wall", 0.5).diffuse("box", 0.25).environment(1);
    builder.object("wall", BoxShape{Vec3(10, 0.2, 10)}, Vec3(0, 2.1, 0), "wall");
    builder.object("box", BoxShape{Vec3(0.3, 0.2, 0.3)}, Vec3(0, 1.6, 0), "box", "box");
    return builder;
}

std::size_t at(int x, int y) {
    return static_cast<std::size_t>(y * 32 + x);
}

TEST(Aovs, StandingScene_IsExactAndWithoutNoise) {
    const SceneBuilder builder = wall_and_box();
    const RenderSettings settings = with_all_aovs(4);
    const std::vector<sim::Track> tracks{test::resting_track("box", Vec3(0, 1.6, 0))};
    const FrameInput frame = static_frame(camera(Vec3(0, 0, 0), Vec3(0, 1, 0), 0.8));
    const PreparedScene scene(builder.scene, settings);
    const Film film = render_frame(scene, tracks, frame, settings);
    ASSERT_EQ(film.aovs.size(), 11u);
    for (int y = 0; y < 18; ++y) {
        for (int x = 0; x < 32; ++x) {
            // The pixel's centre on the plane at distance 1.
            const double scale = 2 * std::tan(0.4) / 18;
            const double right = (x + 0.5 - 16) * scale * 1.5;
            const double up = (9 - y - 0.5) * scale * 1.5;
            const bool box = std::abs(right) < 0.15 && std::abs(up) < 0.15;
            EXPECT_NEAR(plane(film, "Z")[at(x, y)], box ? 1.5f : 2.0f, 2e-6f);
            EXPECT_EQ(plane(film, "object_id.X")[at(x, y)], box ? 2 : 1);
            EXPECT_EQ(plane(film, "motion.X")[at(x, y)], 0);
            EXPECT_EQ(plane(film, "motion.Y")[at(x, y)], 0);
            EXPECT_EQ(plane(film, "N.Y")[at(x, y)], -1);
        }
    }
    EXPECT_EQ(plane(film, "albedo.G")[at(16, 9)], 0.25f);
    EXPECT_EQ(plane(film, "albedo.G")[at(1, 1)], 0.5f);

    const Film again = render_frame(scene, tracks, frame, settings);
    for (std::size_t i = 0; i < film.aovs.size(); ++i) {
        EXPECT_EQ(film.aovs[i].name, again.aovs[i].name);
        EXPECT_EQ(film.aovs[i].values, again.aovs[i].values);
    }
}

TEST(Aovs, MoreSamples_ChangeNoDepthIdOrMotion) {
    const SceneBuilder builder = wall_and_box();
    const std::vector<sim::Track> tracks{
        test::straight_track("box", Vec3(-0.2, 1.6, 0), Vec3(0.2, 1.6, 0), 0, 0.02)};
    CameraState state = camera(Vec3(0, 0, 0), Vec3(0, 1, 0), 0.8);
    state.lens_radius = 0.05;
    FrameInput frame = static_frame(state);
    frame.scene_close = 0.02;
    const RenderSettings few = with_all_aovs(1);
    const RenderSettings many = with_all_aovs(9);
    const PreparedScene scene(builder.scene, few);
    const Film a = render_frame(scene, tracks, frame, few);
    const Film b = render_frame(scene, tracks, frame, many);
    for (const char* name : {"Z", "object_id.X", "motion.X", "motion.Y"}) {
        EXPECT_EQ(plane(a, name), plane(b, name)) << name;
    }
}

// Checks every bit of the noise-free planes of a small scene. They change only with the renderer's
// revision.
TEST(Aovs, PlanesWithoutNoise_HaveTheirBytes) {
    SceneBuilder builder = wall_and_box();
    builder.sphere("ball", 0.25, Vec3(0.3, 1.4, 0.1), "wall", "ball");
    const std::vector<sim::Track> tracks{
        test::straight_track("box", Vec3(-0.2, 1.6, 0), Vec3(0.2, 1.6, 0.03), 0, 0.02),
        test::straight_track("ball", Vec3(0.3, 1.4, 0.1), Vec3(0.25, 1.3, 0.1), 0, 0.02)};
    CameraState state = camera(Vec3(0, 0, 0), Vec3(0.05, 1, 0.1), 0.8);
    state.lens_radius = 0.02;
    FrameInput frame = static_frame(state);
    frame.scene_close = 0.02;
    RenderSettings settings = small_settings(32, 18, 2);
    settings.aovs = {"depth", "motion", "object_id", "material_id"};
    const Film film = render_frame(PreparedScene(builder.scene, settings), tracks, frame, settings);
    Hasher hasher;
    for (const Channel& channel : film.aovs) {
        hasher.add(channel.name);
        for (const float value : channel.values) {
            hasher.add(std::bit_cast<std::uint32_t>(value));
        }
    }
    EXPECT_EQ(hasher.finish().to_string(), "7bdea505c78a07e22d1b328e1711133c");
}

TEST(Aovs, MovingBox_HasItsMotionInPixels) {
    const SceneBuilder builder = wall_and_box();
    const RenderSettings settings = with_all_aovs(1);
    // 0.1 m to the right and 0.05 m up at 1.5 m (the box's front): in pixels of 2 tan(0.4) / 18.
    const std::vector<sim::Track> tracks{
        test::straight_track("box", Vec3(-0.05, 1.6, 0), Vec3(0.05, 1.6, 0.05), 0, 0.02)};
    FrameInput frame = static_frame(camera(Vec3(0, 0, 0), Vec3(0, 1, 0), 0.8));
    frame.scene_close = 0.02;
    const Film film = render_frame(PreparedScene(builder.scene, settings), tracks, frame, settings);
    const double pixel = 1.5 * 2 * std::tan(0.4) / 18;
    ASSERT_EQ(plane(film, "object_id.X")[at(16, 8)], 2);
    EXPECT_NEAR(plane(film, "motion.X")[at(16, 8)], 0.1 / pixel, 1e-3);
    EXPECT_NEAR(plane(film, "motion.Y")[at(16, 8)], -0.05 / pixel, 1e-3);
    EXPECT_EQ(plane(film, "motion.X")[at(1, 1)], 0);
}

TEST(Aovs, MovingCamera_MovesTheBackgroundToo) {
    SceneBuilder builder;
    builder.environment(1);
    const RenderSettings settings = with_all_aovs(1);
    FrameInput frame = static_frame(camera(Vec3(0, 0, 0), Vec3(0, 1, 0), 0.8));
    frame.camera_close.target = Vec3(0.1, 1, 0);
    frame.scene_close = 0.02;
    const Film film = render_frame(PreparedScene(builder.scene, settings), {}, frame, settings);
    EXPECT_LT(plane(film, "motion.X")[at(16, 9)], -1);
    EXPECT_EQ(plane(film, "Z")[at(16, 9)], kFarDepth);
    EXPECT_EQ(plane(film, "object_id.X")[at(16, 9)], 0);
}

TEST(Cryptomatte, BlurAndDefocus_CoveragesAddUpToAlpha) {
    SceneBuilder builder;
    builder.diffuse("paint", 0.5).diffuse("gold", 0.25).environment(1);
    builder.object("box", BoxShape{Vec3(0.6, 0.2, 0.3)}, Vec3(0, 1.6, 0), "paint", "box");
    builder.sphere("ball", 0.2, Vec3(0.3, 1.2, 0.1), "gold");
    builder.sphere("other ball", 0.2, Vec3(-0.5, 2.2, 0), "gold");
    builder.scene.lights.push_back({"star", PointLight{}});  // which no ray can hit
    builder.bulb(Vec3(-0.3, 1.4, 0.2), 0.08, 3);
    builder.scene.lights.back().name = "bulb";
    const std::vector<sim::Track> tracks{
        test::straight_track("box", Vec3(-0.2, 1.6, 0), Vec3(0.2, 1.6, 0.1), 0, 0.02)};
    CameraState state = camera(Vec3(0, 0, 0), Vec3(0, 1, 0), 0.8);
    state.lens_radius = 0.05;
    FrameInput frame = static_frame(state);
    frame.scene_close = 0.02;
    for (const double noise : {0.0, 0.05}) {
        RenderSettings settings = small_settings(32, 18, 32);
        settings.noise = noise;
        settings.aovs = {"cryptomatte_object", "depth", "cryptomatte_material"};
        const Film film =
            render_frame(PreparedScene(builder.scene, settings), tracks, frame, settings);
        ASSERT_EQ(film.aovs.size(), 25u);
        double boxes = 0;
        double mixed = 0;
        for (std::size_t i = 0; i < 32u * 18u; ++i) {
            const double alpha = film.rgba[4 * i + 3];
            EXPECT_NEAR(coverage(film, "CryptoObject", i), alpha, 1e-6);
            EXPECT_NEAR(coverage(film, "CryptoMaterial", i), alpha, 1e-6);
            EXPECT_NEAR(coverage(film, "CryptoObject", i, "ball") +
                            coverage(film, "CryptoObject", i, "other ball"),
                        coverage(film, "CryptoMaterial", i, "gold"), 1e-6);
            EXPECT_NEAR(coverage(film, "CryptoObject", i, "bulb"),
                        coverage(film, "CryptoMaterial", i, "light"), 1e-6);
            boxes += coverage(film, "CryptoObject", i, "box");
            mixed += plane(film, "CryptoObject00.A")[i] > 0 ? 1 : 0;
            EXPECT_GE(plane(film, "CryptoObject00.G")[i], plane(film, "CryptoObject00.A")[i]);
        }
        // The front face is 0.6 x 0.3 at 1.5 m, in pixels of 2 tan(0.4) / 18; part of it is hidden.
        const double pixel = 1.5 * 2 * std::tan(0.4) / 18;
        EXPECT_LT(boxes, 1.1 * 0.18 / (pixel * pixel));
        EXPECT_GT(boxes, 0.5 * 0.18 / (pixel * pixel));
        EXPECT_GT(mixed, 20);
        EXPECT_EQ(film.notes.size(), 8u);
        EXPECT_NE(film.notes.at("cryptomatte/3ae39a5/manifest").find("\"other ball\":\""),
                  std::string::npos);
    }
}

TEST(Aovs, MaterialId_IsThatOfTheScene) {
    SceneBuilder builder = wall_and_box();
    builder.bulb(Vec3(0, 1, 0.2), 0.05, 3);
    RenderSettings settings = small_settings(32, 18, 1);
    settings.aovs = {"material_id", "object_id"};
    const std::vector<sim::Track> tracks{test::resting_track("box", Vec3(0, 1.6, 0))};
    const FrameInput frame = static_frame(camera(Vec3(0, 0, 0), Vec3(0, 1, 0), 0.8));
    const Film film = render_frame(PreparedScene(builder.scene, settings), tracks, frame, settings);
    for (std::size_t i = 0; i < 32u * 18u; ++i) {
        const float object = plane(film, "object_id.X")[i];
        EXPECT_EQ(plane(film, "material_id.X")[i], object == 3 ? 0 : object);
    }
}

TEST(Aovs, Variance_IsTheMeansAndFallsWithSamples) {
    SceneBuilder builder;
    builder.diffuse("wall", 0.5).environment(0.1).lamp(Vec3(0, 1, 1), 0.4, 0.4, 5);
    builder.object("wall", BoxShape{Vec3(10, 0.2, 10)}, Vec3(0, 2.1, 0), "wall");
    const FrameInput frame = static_frame(camera(Vec3(0, 0, 0), Vec3(0, 1, 0), 0.8));
    const auto mean_variance = [&](int samples) {
        const RenderSettings settings = with_all_aovs(samples);
        const Film film = render_frame(PreparedScene(builder.scene, settings), {}, frame, settings);
        double sum = 0;
        for (const float v : plane(film, "variance.X")) {
            EXPECT_GE(v, 0);
            sum += v;
        }
        return sum;
    };
    const double ratio = mean_variance(16) / mean_variance(64);
    EXPECT_GT(ratio, 3);
    EXPECT_LT(ratio, 5.5);
}

/// The mean over the pixels of the variance of their luminance over seeds, and of what the channel
/// says of it.
struct MeanVariances {
    double empirical = 0;
    double channel = 0;
};

MeanVariances variances_of_table(bool halves) {
    constexpr int kSeeds = 48;
    constexpr int kSamples = 32;
    RenderSettings settings = with_all_aovs(kSamples);
    settings.for_denoiser = halves;
    const PreparedScene scene(test::table().scene, settings);
    std::vector<double> sums(std::size_t{32} * 18), squares(sums.size());
    MeanVariances result;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        FrameInput frame = test::table_frame();
        frame.seed = static_cast<std::uint64_t>(seed);
        const Film film = render_frame(scene, test::table_tracks(), frame, settings);
        const std::vector<float>& variance = plane(film, "variance.X");
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const float* rgb = &film.rgba[4 * i];
            const auto y = static_cast<double>(luminance(V3f(rgb[0], rgb[1], rgb[2])));
            sums[i] += y;
            squares[i] += y * y;
            result.channel += static_cast<double>(variance[i]);
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const double mean = sums[i] / kSeeds;
        result.empirical += (squares[i] / kSeeds - mean * mean) * kSeeds / (kSeeds - 1);
    }
    result.channel /= kSeeds;
    return result;
}

TEST(Aovs, VarianceOfFramesWithHalves_IsThatOverSeeds) {
    const MeanVariances found = variances_of_table(true);
    EXPECT_GT(found.channel, found.empirical / 1.2);
    EXPECT_LT(found.channel, found.empirical * 1.2);
}

// Well distributed samples deviate less than independent ones, as which they are taken.
TEST(Aovs, VarianceOfEvenSamples_IsTooLarge) {
    const MeanVariances found = variances_of_table(false);
    EXPECT_GT(found.channel, 2 * found.empirical);
}

}  // namespace
}  // namespace carom::render
