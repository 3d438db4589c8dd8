// What a small frame costs and gains, as counts: rays, bytes and the error that the denoiser takes
// away. Times would depend on the machine. CAROM_WRITE_GOLDEN=1 writes a new reference.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "render/frame/denoiser_planes.h"
#include "render/frame/frame_session.h"
#include "tests/folders.h"
#include "tests/render/frame/table_scene.h"

namespace carom::render {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 36;
constexpr double kPixels = kWidth * kHeight;
constexpr int kSamples = 8;

RenderSettings cost_settings(bool for_denoiser, double noise) {
    RenderSettings settings = test::small_settings(kWidth, kHeight, kSamples);
    settings.filter = PixelFilter::blackman_harris;
    settings.filter_width = 1.5;
    settings.for_denoiser = for_denoiser;
    settings.noise = noise;
    settings.max_samples = 128;
    return settings;
}

Film rendered(const RenderSettings& settings) {
    return render_frame(PreparedScene(test::table().scene, settings), test::table_tracks(),
                        test::table_frame(), settings);
}

/// The colours of the frame with 16,384 samples.
std::vector<double> reference() {
    const std::filesystem::path path =
        std::filesystem::path(CAROM_SOURCE_DIR) / "tests/render/golden/table_64x36.txt";
    if (std::getenv("CAROM_WRITE_GOLDEN") != nullptr) {
        RenderSettings settings = cost_settings(false, 0);
        settings.samples = 16'384;
        const Film film = rendered(settings);
        std::ofstream file(path);
        file.precision(5);
        for (std::size_t i = 0; i < film.rgba.size(); i += 4) {
            file << film.rgba[i] << ' ' << film.rgba[i + 1] << ' ' << film.rgba[i + 2] << '\n';
        }
    }
    std::ifstream file(path);
    return {std::istream_iterator<double>(file), std::istream_iterator<double>()};
}

/// The mean over pixels and channels of (x - r)^2 / (r^2 + 0.01).
double relative_error(const Film& film, const std::vector<double>& truth) {
    double sum = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const double d = static_cast<double>(film.rgba[i / 3 * 4 + i % 3]) - truth[i];
        sum += d * d / (truth[i] * truth[i] + 0.01);
    }
    return sum / static_cast<double>(truth.size());
}

TEST(FrameCost, Denoiser_TakesAwayAsMuchOfTheErrorAsItDid) {
    const std::vector<double> truth = reference();
    ASSERT_EQ(truth.size(), static_cast<std::size_t>(3 * kPixels));
    const Film noisy = rendered(cost_settings(true, 0));
    const double before = relative_error(noisy, truth);
    const double after = relative_error(denoised(noisy), truth);
    // 2.67 when this was written. What a picture of 64 x 36 pixels gains is less than
    // what a large one does, whose pixels have more neighbours like themselves.
    EXPECT_GT(before / after, 2.5) << before << " " << after;
    EXPECT_LT(before, 0.0019) << "the noise of the samples themselves";
}

TEST(FrameCost, Rays_AreAsManyAsTheyWere) {
    const RenderStatistics count = rendered(cost_settings(true, 0)).statistics;
    EXPECT_EQ(count.camera_rays, static_cast<std::uint64_t>(kPixels * kSamples));
    EXPECT_NEAR(static_cast<double>(count.scattered_rays) / (kPixels * kSamples), 1.175, 0.02);
    EXPECT_NEAR(static_cast<double>(count.shadow_rays) / (kPixels * kSamples), 5.3, 0.05);
    EXPECT_EQ(count.unusable_samples, 0u);
    // With adaptive sampling: what it takes to bring the error down to 1 %.
    const RenderStatistics adaptive = rendered(cost_settings(true, 0.01)).statistics;
    EXPECT_NEAR(static_cast<double>(adaptive.camera_rays) / kPixels, 22.5, 1.1);
}

/// Bytes per pixel of the sums once a frame has all its samples.
double bytes_of_sums(const RenderSettings& settings) {
    const PreparedScene scene(test::table().scene, settings);
    FrameSums::Data sums;
    FrameSession session(scene, test::table_tracks(), test::table_frame(), settings,
                         SumsKind::needed_by(settings), sums);
    SessionObserver nobody;
    session.refine(std::numeric_limits<int>::max(), {}, nobody);
    std::size_t bytes = 0;
    for (const TileSums& tile : sums.tiles) {
        bytes += tile.bytes();
    }
    return static_cast<double>(bytes) / kPixels;
}

TEST(FrameCost, Sums_TakeNoMoreMemoryThanTheFrameNeeds) {
    EXPECT_EQ(bytes_of_sums(cost_settings(false, 0)), 32);  // light, coverage, number of samples
    // How the light of both halves differs, and the plan.
    EXPECT_EQ(bytes_of_sums(cost_settings(false, 0.02)), 32 + 12 + 4);
    // The variance, and what both halves saw, which would be 72 bytes if light were seen all over;
    // and with a plan, the rays of the pixels that need some. 111 and 121 when this was written.
    EXPECT_LE(bytes_of_sums(cost_settings(true, 0)), 113);
    EXPECT_LE(bytes_of_sums(cost_settings(true, 0.01)), 123);
    RenderSettings channels = cost_settings(false, 0);
    channels.aovs = {"normal", "variance", "depth"};
    EXPECT_EQ(bytes_of_sums(channels), 32 + 56 + 8);
    // In a finished frame each of the denoiser's channels takes a half float.
    std::size_t bytes = 0;
    for (const HalfChannel& channel : rendered(cost_settings(true, 0)).half_aovs) {
        bytes += channel.bits.size() * sizeof(channel.bits[0]);
    }
    EXPECT_EQ(static_cast<double>(bytes) / kPixels, 64);
}

}  // namespace
}  // namespace carom::render
