#include "pipeline/job/memory_forecast.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace carom::pipeline {
namespace {

Shot film_of(int width, int height) {
    Shot shot;
    shot.render.width = width;
    shot.render.height = height;
    return shot;
}

Shot encoded_with(int width, int height, Codec codec, const std::string& preset) {
    Shot shot = film_of(width, height);
    shot.output.codec = codec;
    shot.output.preset = preset;
    return shot;
}

double megabytes(const Shot& shot, const std::string& output) {
    return static_cast<double>(forecast_memory(shot, output)) / 1e6;
}

/// The measurements of whole jobs in docs/reliability.md.
TEST(ForecastMemory_OfMeasuredJobs, IsLessThanAQuarterAboveAndNeverMuchBelow) {
    const auto expect_near = [](double forecast, double measured) {
        EXPECT_LT(forecast, 1.25 * measured);
        EXPECT_GT(forecast, 0.95 * measured);
    };
    expect_near(megabytes(film_of(1920, 1080), "shot.####.exr"), 285);
    expect_near(megabytes(encoded_with(1920, 1080, Codec::h264, "veryfast"), "f.mp4"), 393);
    expect_near(megabytes(encoded_with(3840, 2160, Codec::h264, "veryfast"), "f.mp4"), 1100);
    expect_near(megabytes(encoded_with(1920, 1080, Codec::h264, "medium"), "f.mp4"), 612);
    expect_near(megabytes(encoded_with(1920, 1080, Codec::vp9, "medium"), "f.webm"), 480);
}

TEST(ForecastMemory_OfAFilmThatKeepsSums, CountsThem) {
    Shot shot = film_of(1000, 1000);
    const std::uint64_t plain = forecast_memory(shot, "f.mp4");
    EXPECT_EQ(forecast_memory(shot, "f.mp4", true), plain + 32'000'000);
    shot.render.noise = 0.05;
    EXPECT_EQ(forecast_memory(shot, "f.mp4"), plain + 46'000'000) << "and measures between rounds";
}

TEST(ForecastMemory_OfDenoisedPictures, CountsChannelsAndTheSumsOfBothHalves) {
    Shot shot = film_of(1000, 1000);
    const std::uint64_t plain = forecast_memory(shot, "f.mp4");
    shot.render.for_denoiser = true;
    EXPECT_EQ(forecast_memory(shot, "f.mp4"), plain + 125'000'000);
    EXPECT_EQ(forecast_memory(shot, "f.mp4", true), plain + 246'000'000);
    shot.render.noise = 0.01;
    EXPECT_EQ(forecast_memory(shot, "f.mp4"), plain + 125'000'000);
}

TEST(ForecastMemory_OfDeepColour, IsMore) {
    Shot shot = encoded_with(1280, 720, Codec::hevc, "medium");
    const double usual = megabytes(shot, "f.mp4");
    shot.output.bits = 10;
    EXPECT_GT(megabytes(shot, "f.mp4"), 1.3 * usual);
}

TEST(ForecastMemory_OfAovs, GrowsWithTheirNumber) {
    Shot shot = film_of(1280, 720);
    const double none = megabytes(shot, "f.mp4");
    shot.render.aovs = {"depth", "normal"};
    EXPECT_GT(megabytes(shot, "f.mp4"), none + 20);
}

TEST(ForecastMemory_OfALargeMesh, GrowsWithItsFile) {
    const std::string path = testing::TempDir() + "memory_forecast_test.obj";
    std::ofstream(path) << std::string(10'000'000, ' ');
    Shot shot = film_of(640, 360);
    const double without = megabytes(shot, "f.mp4");
    shot.assets.push_back({path, {}});
    EXPECT_NEAR(megabytes(shot, "f.mp4"), without + 33, 1);
    std::filesystem::remove(path);
}

TEST(MemoryText, ManyBytes_AreRounded) {
    EXPECT_EQ(memory_text(44'000'000), "44 MB");
    EXPECT_EQ(memory_text(583'000'000), "580 MB");
    EXPECT_EQ(memory_text(996'000'000), "1000 MB");
    EXPECT_EQ(memory_text(1'250'000'000), "1.2 GB");
}

}  // namespace
}  // namespace carom::pipeline
