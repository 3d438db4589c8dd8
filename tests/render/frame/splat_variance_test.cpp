// The variance of light that is splatted onto pixels.
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/colour.h"
#include "render/frame/progressive_frame.h"
#include "render/frame/splat_moments.h"
#include "render/geometry/ray.h"
#include "tests/render/scene_builder.h"

namespace carom::render {
namespace {

using test::SceneBuilder;

constexpr int kSide = 24;  // pixels
constexpr int kSeeds = 64;

TEST(SplatMoments, QuartersThatDiffer_GiveTheVarianceOfTheirMean) {
    SplatMoments moments(2);
    // Four times the sums of the quarters are 4, 12, 0 and 0: the mean is 4, the variance of a
    // quarter 96 / 3, that of the whole an eighth of it.
    moments.add(1, 0, 1);
    moments.add(1, 1, 1);
    moments.add(1, 1, 2);
    moments.finish_image(0.5f);
    EXPECT_EQ(moments.mean()[0], 0);
    EXPECT_EQ(moments.variance()[0], 0);
    EXPECT_FLOAT_EQ(moments.mean()[1], 2);
    EXPECT_FLOAT_EQ(moments.variance()[1], 0.25f * 4);
    // Another image adds to both pixels.
    for (int quarter = 0; quarter < 4; ++quarter) {
        moments.add(0, quarter, 2);
        moments.add(1, quarter, quarter == 3 ? 2 : 0);
    }
    moments.finish_image(1);
    EXPECT_EQ(moments.mean()[0], 8);
    EXPECT_EQ(moments.variance()[0], 0);
    EXPECT_FLOAT_EQ(moments.mean()[1], 4);
    EXPECT_FLOAT_EQ(moments.variance()[1], 1 + 2);
}

/// A black smooth ball before a bulb: all light that the camera sees is splatted.
struct BlackBall {
    SceneBuilder builder;
    FrameInput frame;

    std::vector<sim::Track> tracks;

    explicit BlackBall(double lens_radius, bool moves = false) {
        StandardMaterial black;
        black.base = Vec3(0, 0, 0);
        black.coat = {1, 1.8, 0};
        builder.material("black", black)
            .sphere("ball", 0.3, Vec3(0, 0, 0.3), "black", moves ? "rolls" : "");
        builder.bulb(Vec3(-1.2, -1.8, 1.5), 0.2, 60);
        CameraState state = test::camera(Vec3(0, -2.6, 0.9), Vec3(0, 0.1, 0.25), 0.4);
        state.lens_radius = lens_radius;
        state.focus_distance = 1.8;
        frame = test::static_frame(state);
        if (moves) {
            frame.scene_close = 0.02;
            tracks.push_back(
                test::straight_track("rolls", Vec3(-0.1, 0, 0.3), Vec3(0.1, 0, 0.3), 0, 0.02));
        }
    }
};

/// Means over the pixels.
struct Variances {
    double estimated = 0;
    double empirical = 0;  // of pixels over seeds
};

Variances variances(BlackBall scene, bool halves) {
    RenderSettings settings = test::small_settings(kSide, kSide, 4);
    settings.aovs = {"variance"};
    settings.for_denoiser = halves;
    const PreparedScene prepared(scene.builder.scene, settings);
    constexpr std::size_t kPixels = std::size_t{kSide} * kSide;
    std::vector<double> sum(kPixels), squares(kPixels);
    Variances result;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        scene.frame.seed = static_cast<std::uint64_t>(seed);
        const Film film = render_frame(prepared, scene.tracks, scene.frame, settings);
        const std::vector<float>& variance = test::plane(film, "variance.X");
        for (std::size_t i = 0; i < kPixels; ++i) {
            const auto y = static_cast<double>(
                luminance(V3f(film.rgba[4 * i], film.rgba[4 * i + 1], film.rgba[4 * i + 2])));
            sum[i] += y;
            squares[i] += y * y;
            result.estimated += static_cast<double>(variance[i]) / (kSeeds * kPixels);
        }
    }
    for (std::size_t i = 0; i < kPixels; ++i) {
        const double mean = sum[i] / kSeeds;
        result.empirical += (squares[i] / kSeeds - mean * mean) * kSeeds / (kSeeds - 1) / kPixels;
    }
    return result;
}

TEST(SplatVariance, IsThatOfPicturesWithOtherSeeds) {
    for (const bool halves : {false, true}) {
        for (const auto& [lens_radius, moves] :
             {std::pair(0.0, false), std::pair(0.06, false), std::pair(0.06, true)}) {
            const Variances found = variances(BlackBall(lens_radius, moves), halves);
            EXPECT_GT(found.empirical, 0);
            EXPECT_GT(found.estimated, found.empirical / 1.5) << halves << lens_radius << moves;
            EXPECT_LT(found.estimated, found.empirical * 1.5) << halves << lens_radius << moves;
        }
    }
}

TEST(SplatVariance, OfAProgressiveFrame_IsTheSame) {
    const BlackBall scene(0.06);
    RenderSettings settings = test::small_settings(kSide, kSide, 4);
    settings.aovs = {"variance"};
    const PreparedScene prepared(scene.builder.scene, settings);
    const Film film = render_frame(prepared, {}, scene.frame, settings);
    ProgressiveFrame progressive(prepared, {}, scene.frame, settings);
    progressive.refine(4);
    EXPECT_EQ(test::plane(progressive.film(), "variance.X"), test::plane(film, "variance.X"));
    EXPECT_EQ(progressive.channels("variance").at(0).values, test::plane(film, "variance.X"));
}

// All light is splatted, and the error is measured.
TEST(SplatVariance, AdaptiveSampling_TakesSamplesForIt) {
    const BlackBall scene(0.06);
    RenderSettings settings = test::small_settings(kSide, kSide, 8);
    settings.max_samples = 512;
    const PreparedScene prepared(scene.builder.scene, settings);
    const auto samples = [&](double noise) {
        settings.noise = noise;
        const Film film = render_frame(prepared, {}, scene.frame, settings);
        return film.statistics.camera_rays;
    };
    EXPECT_EQ(samples(1), std::uint64_t{8} * kSide * kSide);
    EXPECT_GT(samples(0.002), std::uint64_t{16} * kSide * kSide);
}

}  // namespace
}  // namespace carom::render
