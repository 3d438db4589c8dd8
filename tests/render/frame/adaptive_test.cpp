#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "render/frame/adaptive_progress.h"
#include "render/frame/denoiser_planes.h"
#include "render/frame/sample_plan.h"
#include "render/threads/thread_arena.h"
#include "tests/render/frame/table_scene.h"
#include "tests/render/scene_builder.h"

namespace carom::render {
namespace {

using test::SceneBuilder;

RenderSettings plan_settings(int width, int height, double noise) {
    RenderSettings settings = test::small_settings(width, height, 8);
    settings.noise = noise;
    settings.max_samples = 512;
    return settings;
}

MeasuredError even_error(std::size_t pixels, double error) {
    return {error, std::vector<float>(pixels, static_cast<float>(error))};
}

TEST(SampleLevels, HalvesHavePowersOfFour) {
    RenderSettings settings = plan_settings(8, 8, 0.01);
    EXPECT_EQ(sample_levels(settings), (std::vector<int>{8, 32, 128, 512}));
    settings.samples = 64;
    settings.max_samples = 1025;
    EXPECT_EQ(sample_levels(settings), (std::vector<int>{64, 128, 512, 1024}));
    settings.max_samples = 16;
    EXPECT_EQ(sample_levels(settings), std::vector<int>{64});
}

TEST(SampleRound, PictureWhoseErrorIsSmallEnough_NeedsNone) {
    const RenderSettings settings = plan_settings(8, 8, 0.01);
    const std::vector<int> plan(64, 8);
    EXPECT_TRUE(next_round(plan, even_error(64, 1.11e-4), settings).is_needed);
    const SampleRound round = next_round(plan, even_error(64, 1.09e-4), settings);
    EXPECT_FALSE(round.is_needed);
    EXPECT_EQ(round.plan, plan);
    EXPECT_EQ(round.expected, plan);
}

TEST(SampleRound, EvenError_RaisesAllByOneLevel) {
    const RenderSettings settings = plan_settings(8, 8, 0.01);
    // The error falls to a 4^1.4th part with each level.
    const SampleRound round = next_round(std::vector<int>(64, 8), even_error(64, 4e-3), settings);
    EXPECT_TRUE(round.is_needed);
    EXPECT_EQ(round.plan, std::vector<int>(64, 32));
    EXPECT_EQ(round.expected, std::vector<int>(64, 128));
}

TEST(SampleRound, PixelsWithTheLargestErrors_AreRaised) {
    const RenderSettings settings = plan_settings(16, 8, 0.01);
    MeasuredError error = even_error(16 * 8, 0);
    for (std::size_t i = 0; i < error.by_pixel.size(); ++i) {
        error.by_pixel[i] = i % 16 < 8 ? 1e-5F : 5e-4F;
        error.mean += static_cast<double>(error.by_pixel[i]) / (16 * 8);
    }
    const SampleRound round = next_round(std::vector<int>(16 * 8, 8), error, settings);
    for (std::size_t i = 0; i < round.plan.size(); ++i) {
        EXPECT_EQ(round.plan[i], i % 16 < 8 ? 8 : 32);
        EXPECT_EQ(round.expected[i], round.plan[i]);
    }
}

TEST(SampleRound, PixelsWithTheMostSamples_StayAsTheyAre) {
    const RenderSettings settings = plan_settings(8, 8, 0.01);
    std::vector<int> plan(64, 512);
    EXPECT_FALSE(next_round(plan, even_error(64, 1), settings).is_needed);
    plan[5] = 128;
    const SampleRound round = next_round(plan, even_error(64, 1), settings);
    EXPECT_TRUE(round.is_needed);
    EXPECT_EQ(round.plan, std::vector<int>(64, 512));
}

// A picture of luminance 1 whose halves differ at one pixel.
TEST(ErrorOfHalves, OwnSamples_HaveNoSayButInTheMean) {
    constexpr int kSide = 9;
    std::vector<V3f> difference(kSide * kSide, V3f(0, 0, 0));
    difference[4 * kSide + 4] = V3f(0.3F, 0, 0);
    const MeasuredError error =
        error_of_halves(std::vector<V3f>(kSide * kSide, V3f(1, 1, 1)), difference, kSide, kSide);
    const double own = 0.09 / 1.01 / 3;
    EXPECT_NEAR(error.mean, own / (kSide * kSide), 1e-9);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const bool is_near = std::abs(x - 4) <= 2 && std::abs(y - 4) <= 2;
            const bool is_own = x == 4 && y == 4;
            EXPECT_NEAR(error.by_pixel[static_cast<std::size_t>(y * kSide + x)],
                        is_near && !is_own ? own / 24 : 0, 1e-7)
                << x << ", " << y;
        }
    }
}

class Progress : public testing::Test {
  protected:
    static constexpr int kTiles = 32;

    /// All tiles take one second for their first samples; the pixels have this error.
    void begin_tiles(int from, int to, float error) {
        for (int n = from; n < to; ++n) {
            progress_.first_samples_done(progress_.nth_tile(n), std::vector<float>(16, error), 1);
        }
    }

    std::vector<double> fractions_;
    ProgressCallback callback_ = [this](double fraction) { fractions_.push_back(fraction); };
    AdaptiveProgress progress_{callback_, plan_settings(512, 16, 0.02), kTiles};
};

TEST_F(Progress, FirstSamples_AreTheFractionThatTheirErrorPredicts) {
    const float error = 4e-4F * 6;  // needs 32 samples
    begin_tiles(0, 1, error);
    EXPECT_TRUE(fractions_.empty()) << "one tile says too little";
    begin_tiles(1, 8, error);
    EXPECT_NEAR(fractions_.back(), 8.0 / kTiles / 4, 1e-6);
    begin_tiles(8, kTiles, error);
    EXPECT_NEAR(fractions_.back(), 0.25, 1e-6);
    progress_.begin_round(std::vector<double>(kTiles, 1), std::vector<double>(kTiles, 3));
    for (int tile = 0; tile < kTiles; ++tile) {
        progress_.tile_done(tile);
    }
    EXPECT_NEAR(fractions_.back(), 0.5, 1e-6);
    progress_.begin_round(std::vector<double>(kTiles, 2), std::vector<double>(kTiles, 2));
    for (int tile = 0; tile < kTiles / 2; ++tile) {
        progress_.tile_done(tile);
    }
    EXPECT_NEAR(fractions_.back(), 0.75, 1e-6);
    for (int tile = kTiles / 2; tile < kTiles; ++tile) {
        progress_.tile_done(tile);
    }
    progress_.finish();
    EXPECT_EQ(fractions_.back(), 1);
    EXPECT_TRUE(std::is_sorted(fractions_.begin(), fractions_.end()));
}

TEST_F(Progress, QuietFrame_IsDoneWithItsFirstSamples) {
    begin_tiles(0, kTiles / 2, 1e-9F);
    EXPECT_NEAR(fractions_.back(), 0.5, 1e-6);
    begin_tiles(kTiles / 2, kTiles, 1e-9F);
    EXPECT_NEAR(fractions_.back(), 1, 1e-6);
}

TEST_F(Progress, RoundThatWasNotExpected_KeepsTheFraction) {
    begin_tiles(0, kTiles, 1e-9F);
    progress_.begin_round(std::vector<double>(kTiles, 1), std::vector<double>(kTiles, 1));
    progress_.tile_done(0);
    EXPECT_NEAR(fractions_.back(), 1, 1e-6);
    EXPECT_TRUE(std::is_sorted(fractions_.begin(), fractions_.end()));
}

TEST_F(Progress, Tiles_AreVisitedOnceAndEarlyOnesEverywhere) {
    for (const int tiles : {1, 2, 3, 60, 919, 920, 8160}) {
        const ProgressCallback nobody;
        const AdaptiveProgress progress(nobody, plan_settings(16, 16, 0.02), tiles);
        std::vector<int> order;
        for (int n = 0; n < tiles; ++n) {
            order.push_back(progress.nth_tile(n));
        }
        if (tiles > 50) {  // each half of the frame has its part of the first sixteenth
            const int early = tiles / 16;
            const auto upper = std::count_if(order.begin(), order.begin() + early,
                                             [&](int tile) { return tile < tiles / 2; });
            EXPECT_NEAR(static_cast<double>(upper), early / 2.0, 2) << tiles;
        }
        std::sort(order.begin(), order.end());
        for (int n = 0; n < tiles; ++n) {
            ASSERT_EQ(order[static_cast<std::size_t>(n)], n) << tiles;
        }
    }
}

/// A ball between a lamp and the floor: noisy in the penumbra and out of focus, quiet elsewhere.
struct Spots {
    SceneBuilder builder;
    FrameInput frame;

    Spots() {
        StandardMaterial ball;
        ball.base = Vec3(0.4, 0.1, 0.1);
        ball.coat.weight = 1;
        builder.diffuse("floor", 0.3).material("ball", ball);
        builder.object("floor", PlaneShape{}, Vec3(0, 0, 0), "floor");
        builder.sphere("ball", 0.3, Vec3(0, 0, 0.3), "ball");
        builder.lamp(Vec3(0.5, 0.3, 1.6), 0.4, 0.3, 12).environment(0.02);
        CameraState state = test::camera(Vec3(0, -2, 1.2), Vec3(0, 0, 0.2), 0.6);
        state.lens_radius = 0.02;
        frame = test::static_frame(state);
    }
};

TEST(AdaptiveSampling, MeanIsThatOfManySamples) {
    Spots scene;
    RenderSettings settings = plan_settings(32, 24, 0.03);
    const PreparedScene prepared(scene.builder.scene, settings);
    std::vector<Vec3> means;
    for (int seed = 1; seed <= 48; ++seed) {
        scene.frame.seed = static_cast<std::uint64_t>(seed);
        means.push_back(test::mean_colour(render_frame(prepared, {}, scene.frame, settings)));
    }
    const double n = static_cast<double>(means.size());
    const Vec3 mean = std::accumulate(means.begin(), means.end(), Vec3(0, 0, 0)) / n;
    Vec3 squares(0, 0, 0);
    for (const Vec3& m : means) {
        squares += (m - mean) * (m - mean);
    }
    settings.noise = 0;
    settings.samples = 4096;
    const Vec3 truth = test::mean_colour(render_frame(prepared, {}, scene.frame, settings));
    for (int c = 0; c < 3; ++c) {
        const double error = std::sqrt(squares[c] / (n * (n - 1)));
        EXPECT_NEAR(mean[c], truth[c], 4 * error + 1e-4 * truth[c]) << c;
        EXPECT_LT(error, 2e-3 * truth[c]) << c;
    }
}

/// sqrt(mean of (x - r)^2 / (r^2 + 0.01)).
double relative_error(const Film& film, const Film& truth) {
    double sum = 0;
    for (std::size_t i = 0; i < film.rgba.size(); ++i) {
        if (i % 4 != 3) {
            const auto r = static_cast<double>(truth.rgba[i]);
            const double d = static_cast<double>(film.rgba[i]) - r;
            sum += d * d / (r * r + 0.01);
        }
    }
    return std::sqrt(sum / (3.0 / 4) / static_cast<double>(film.rgba.size()));
}

/// Errors of a frame of the table, means over a few seeds.
struct TableErrors {
    double error = 0;
    double samples = 0;  // per pixel
};

class AdaptiveTable : public testing::TestWithParam<bool> {
  protected:
    AdaptiveTable() {
        RenderSettings many = settings_;
        many.samples = 1024;
        truth_ = render_frame(scene_, test::table_tracks(), frame_of_seed(100), many);
    }

    [[nodiscard]] TableErrors measure(const RenderSettings& settings) const {
        constexpr int kSeeds = 3;
        double squares = 0;
        TableErrors result;
        for (int seed = 1; seed <= kSeeds; ++seed) {
            Film film = render_frame(scene_, test::table_tracks(), frame_of_seed(seed), settings);
            result.samples += static_cast<double>(film.statistics.camera_rays) /
                              (settings.width * settings.height * kSeeds);
            film = settings.for_denoiser ? denoised(film) : film;
            squares += std::pow(relative_error(film, truth_), 2) / kSeeds;
        }
        result.error = std::sqrt(squares);
        return result;
    }

    static FrameInput frame_of_seed(int seed) {
        FrameInput frame = test::table_frame();
        frame.seed = static_cast<std::uint64_t>(seed);
        return frame;
    }

    RenderSettings settings_ = test::small_settings(128, 96, 8);
    PreparedScene scene_{test::table().scene, settings_};
    Film truth_;
};

TEST_P(AdaptiveTable, ErrorIsTheTarget_AndEvenSamplesLeaveMore) {
    settings_.for_denoiser = GetParam();
    settings_.samples = GetParam() ? 32 : 8;
    settings_.max_samples = 2048;
    settings_.noise = GetParam() ? 0.004 : 0.008;
    const TableErrors adaptive = measure(settings_);
    EXPECT_GT(adaptive.error, settings_.noise / 1.3);
    EXPECT_LT(adaptive.error, settings_.noise * 1.3);
    EXPECT_GT(adaptive.samples, 1.2 * settings_.samples);
    settings_.noise = 0;
    settings_.samples = 2 * static_cast<int>(adaptive.samples / 2);
    EXPECT_LT(adaptive.error, 0.9 * measure(settings_).error) << settings_.samples;
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutDenoiser, AdaptiveTable, testing::Values(false, true),
                         [](const testing::TestParamInfo<bool>& tested) {
                             return tested.param ? "Denoised" : "Noisy";
                         });

TEST(AdaptiveSampling, FrameThatNeedsNoMore_HasItsProgressInItsFirstSamples) {
    const Spots scene;
    const RenderSettings settings = plan_settings(96, 64, 1);
    const PreparedScene prepared(scene.builder.scene, settings);
    std::vector<double> fractions;
    WorkContext context;
    context.progress = [&](double fraction) { fractions.push_back(fraction); };
    const Film film = render_frame(prepared, {}, scene.frame, settings, context);
    EXPECT_EQ(film.statistics.camera_rays, 96u * 64 * 8);
    constexpr std::size_t kTiles = 6 * 4;
    ASSERT_EQ(fractions.size(), kTiles + 1);
    for (std::size_t i = 0; i < kTiles; ++i) {
        EXPECT_NEAR(fractions[i], static_cast<double>(i + 1) / kTiles, 1e-9);
    }
    EXPECT_EQ(fractions.back(), 1);
}

TEST(AdaptiveSampling, OneThreadAndTwo_GiveTheSameBits) {
    const Spots scene;
    const RenderSettings settings = plan_settings(32, 24, 0.03);
    const PreparedScene prepared(scene.builder.scene, settings);
    const auto with_threads = [&](int threads) {
        Film film;
        ThreadArena arena(threads);
        arena.execute([&] { film = render_frame(prepared, {}, scene.frame, settings); });
        return film;
    };
    EXPECT_EQ(with_threads(1).rgba, with_threads(2).rgba);
}

}  // namespace
}  // namespace carom::render
