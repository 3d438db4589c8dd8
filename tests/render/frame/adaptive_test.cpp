#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "render/frame/adaptive_progress.h"
#include "render/frame/sample_plan.h"
#include "render/threads/thread_arena.h"
#include "tests/render/scene_builder.h"

namespace carom::render {
namespace {

using test::SceneBuilder;

RenderSettings plan_settings(int width, int height, double noise) {
    RenderSettings settings = test::small_settings(width, height, 16);
    settings.noise = noise;
    settings.max_samples = 256;
    return settings;
}

/// A pixel of luminance 1 whose groups of four samples deviate by `spread` up and down.
PixelSums pixel(float spread) {
    PixelSums sums;
    sums.groups = {4 + 4 * spread, 4 - 4 * spread, 4 + 4 * spread, 4 - 4 * spread};
    return sums;
}

TEST(SamplePlan, QuietPictures_GetTheLeast) {
    const RenderSettings settings = plan_settings(8, 8, 0.01);
    const std::vector<PixelSums> pilot(64, pixel(0.001f));
    EXPECT_EQ(plan_samples(pilot, settings), std::vector<int>(64, 16));
}

TEST(SamplePlan, EvenNoise_GetsWhatTheSquareRootLawSays) {
    RenderSettings settings = plan_settings(8, 8, 0.02);
    // Groups that differ by s: the mean of four has the variance s^2 / 3.
    const std::vector<PixelSums> pilot(64, pixel(0.1f));
    const double variance = 0.01 / 3 / 1.01;
    const double wanted = 16 * variance / (0.02 * 0.02);  // 132
    for (const int samples : plan_samples(pilot, settings)) {
        EXPECT_GE(samples, wanted);
        EXPECT_LT(samples, wanted + 5);
        EXPECT_EQ(samples % 4, 0);
    }
    settings.max_samples = 64;
    EXPECT_EQ(plan_samples(pilot, settings), std::vector<int>(64, 64));
}

TEST(SamplePlan, NoisyHalf_GetsMoreByItsDeviation) {
    RenderSettings settings = plan_settings(16, 8, 0.03);
    settings.max_samples = 4096;
    std::vector<PixelSums> pilot;
    for (int i = 0; i < 16 * 8; ++i) {
        pilot.push_back(pixel(i % 16 < 8 ? 0.1f : 0.3f));
    }
    const std::vector<int> plan = plan_samples(pilot, settings);
    EXPECT_NEAR(plan[4 * 16 + 12], 3 * plan[4 * 16 + 3], 12);
}

TEST(SamplePlan, OwnSamples_HaveNoSayButInTheCommonScale) {
    RenderSettings settings = plan_settings(32, 32, 0.02);
    settings.max_samples = 65536;
    std::vector<PixelSums> pilot(32 * 32, pixel(0.1f));
    const std::size_t odd = 16 * 32 + 16;
    pilot[odd] = pixel(0.9f);
    const std::vector<int> plan = plan_samples(pilot, settings);
    EXPECT_EQ(plan[odd], plan[0]);          // the same as a pixel whose neighbourhood is average
    EXPECT_GT(plan[odd + 1], 2 * plan[0]);  // a neighbour of the noisy pixel
}

class Progress : public testing::Test {
  protected:
    static constexpr int kTiles = 32;

    /// All tiles take one second for their first samples; the samples of every pixel have this
    /// deviation.
    void begin_tiles(int from, int to, double deviation) {
        for (int n = from; n < to; ++n) {
            progress_.first_samples_done(progress_.nth_tile(n), std::vector<double>(16, deviation),
                                         1);
        }
    }

    std::vector<double> fractions_;
    ProgressCallback callback_ = [this](double fraction) { fractions_.push_back(fraction); };
    AdaptiveProgress progress_{callback_, plan_settings(512, 16, 0.02), kTiles};
};

TEST_F(Progress, FirstSamples_AreTheFractionThatTheirNoisePredicts) {
    const double deviation = 0.02 * std::sqrt(64);  // needs 64 samples for a noise of 0.02
    begin_tiles(0, 1, deviation);
    EXPECT_TRUE(fractions_.empty()) << "one tile says too little";
    begin_tiles(1, 8, deviation);
    EXPECT_NEAR(fractions_.back(), 8.0 / kTiles / 4, 1e-6);
    begin_tiles(8, kTiles, deviation);
    EXPECT_NEAR(fractions_.back(), 0.25, 1e-6);
    progress_.set_plan(std::vector<double>(kTiles, 3));
    for (int tile = 0; tile < kTiles / 2; ++tile) {
        progress_.tile_done(tile);
    }
    EXPECT_NEAR(fractions_.back(), 0.25 + 0.5 * 0.75, 1e-6);
    for (int tile = kTiles / 2; tile < kTiles; ++tile) {
        progress_.tile_done(tile);
    }
    EXPECT_EQ(fractions_.back(), 1);
    EXPECT_TRUE(std::is_sorted(fractions_.begin(), fractions_.end()));
}

TEST_F(Progress, QuietFrame_IsDoneWithItsFirstSamples) {
    begin_tiles(0, kTiles / 2, 1e-6);
    EXPECT_NEAR(fractions_.back(), 0.5, 1e-6);
    begin_tiles(kTiles / 2, kTiles, 1e-6);
    EXPECT_NEAR(fractions_.back(), 1, 1e-6);
}

TEST_F(Progress, PlanWithMoreSamplesThanExpected_KeepsTheFraction) {
    begin_tiles(0, kTiles, 1e-6);
    progress_.set_plan(std::vector<double>(kTiles, 1));
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

double mean_red(const Film& film) {
    double sum = 0;
    for (std::size_t i = 0; i < film.rgba.size(); i += 4) {
        sum += static_cast<double>(film.rgba[i]);
    }
    return 4 * sum / static_cast<double>(film.rgba.size());
}

TEST(AdaptiveSampling, MeanIsThatOfManySamples) {
    Spots scene;
    RenderSettings settings = plan_settings(32, 24, 0.03);
    const PreparedScene prepared(scene.builder.scene, settings);
    std::vector<double> means;
    for (int seed = 1; seed <= 48; ++seed) {
        scene.frame.seed = static_cast<std::uint64_t>(seed);
        means.push_back(mean_red(render_frame(prepared, {}, scene.frame, settings)));
    }
    const double n = static_cast<double>(means.size());
    const double mean = std::accumulate(means.begin(), means.end(), 0.0) / n;
    double squares = 0;
    for (const double m : means) {
        squares += (m - mean) * (m - mean);
    }
    const double error = std::sqrt(squares / (n * (n - 1)));
    settings.noise = 0;
    settings.samples = 4096;
    const double truth = mean_red(render_frame(prepared, {}, scene.frame, settings));
    EXPECT_NEAR(mean, truth, 4 * error + 1e-4 * truth);
    EXPECT_LT(error, 2e-3 * truth);
}

TEST(AdaptiveSampling, ReachesItsTargetWithFewerSamplesThanEvenOnes) {
    Spots scene;
    RenderSettings settings = plan_settings(48, 32, 0.005);
    settings.max_samples = 4096;
    const PreparedScene prepared(scene.builder.scene, settings);
    const auto render = [&](int seed, const RenderSettings& with) {
        scene.frame.seed = static_cast<std::uint64_t>(seed);
        return render_frame(prepared, {}, scene.frame, with);
    };
    RenderSettings many = settings;
    many.noise = 0;
    many.samples = 4096;
    const Film truth = render(100, many);
    const auto error_of = [&](const Film& film) {
        double sum = 0;
        for (std::size_t i = 0; i < film.rgba.size(); i += 4) {
            const auto y = [&](const Film& f) {
                return static_cast<double>(luminance(V3f(f.rgba[i], f.rgba[i + 1], f.rgba[i + 2])));
            };
            const double d = y(film) - y(truth);
            sum += d * d / (y(truth) * y(truth) + 0.01);
        }
        return std::sqrt(4 * sum / static_cast<double>(film.rgba.size()));
    };
    const Film film = render(1, settings);
    EXPECT_LT(error_of(film), 0.0055);
    RenderSettings even = settings;
    even.noise = 0;
    even.samples = static_cast<int>(film.statistics.camera_rays / (48 * 32));
    EXPECT_GT(even.samples, 16);
    EXPECT_LT(error_of(film), 0.8 * error_of(render(1, even)));
}

TEST(AdaptiveSampling, FrameThatNeedsNoMore_HasItsProgressInItsFirstSamples) {
    const Spots scene;
    const RenderSettings settings = plan_settings(96, 64, 1);
    const PreparedScene prepared(scene.builder.scene, settings);
    std::vector<double> fractions;
    WorkContext context;
    context.progress = [&](double fraction) { fractions.push_back(fraction); };
    const Film film = render_frame(prepared, {}, scene.frame, settings, context);
    EXPECT_EQ(film.statistics.camera_rays, 96u * 64 * 16);
    constexpr std::size_t kTiles = 6 * 4;
    ASSERT_GT(fractions.size(), kTiles);
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
