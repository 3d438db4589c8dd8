// Tests of the forecast of a film. None of them asserts a time, which depends on the machine.
#include "pipeline/job/film_forecast.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/job/film_status.h"
#include "tests/pipeline/job/tiny_shot.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ScratchFolder;
using ::testing::IsEmpty;

namespace fs = std::filesystem;

/// The tiny shot: twelve frames as nine pictures.
struct ForecastFixture {
    ScratchFolder folder;
    Shot shot = carom::testing::tiny_shot();
    sim::Bake bake{carom::testing::tiny_timeline(), {}, {}, {}};

    [[nodiscard]] FilmJobOptions options(const std::string& output) const {
        FilmJobOptions options;
        options.output = output.empty() ? "" : folder.path(output);
        options.cache_folder = folder.path("cache");
        return options;
    }
    [[nodiscard]] FilmForecast forecast(const std::string& output,
                                        const std::stop_token& stop = {}) const {
        const FilmStatus status = film_status(shot, bake, options(output), {});
        // As large blocks on a slow machine or with sanitizers as elsewhere.
        const ForecastSettings settings{.cpu_limit = 1000, .cpu_at_least = 900};
        return forecast_film(shot, bake, status.missing, options(output), stop, settings);
    }
    /// The files below the folder, without empty folders.
    [[nodiscard]] std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(folder.path(""))) {
            if (entry.is_regular_file()) {
                names.push_back(entry.path().filename().string());
            }
        }
        return names;
    }
};

TEST(FilmForecast, OfAFilm_IsConsistent) {
    const ForecastFixture film;
    const FilmForecast forecast = film.forecast("film.mkv");
    EXPECT_EQ(forecast.frames, 12);
    EXPECT_EQ(forecast.pictures, 9);
    EXPECT_GT(forecast.seconds_per_picture, 0);
    EXPECT_GT(forecast.serial_per_picture, 0);
    EXPECT_LE(forecast.serial_per_picture, forecast.seconds_per_picture);
    EXPECT_DOUBLE_EQ(forecast.cpu_seconds(), forecast.preparation_seconds +
                                                 9 * forecast.seconds_per_picture +
                                                 forecast.encoding_seconds);
    EXPECT_GE(forecast.elapsed_seconds(1, 1), forecast.cpu_seconds());
    EXPECT_LE(forecast.elapsed_seconds(1, 2), forecast.elapsed_seconds(1, 1));
    EXPECT_GT(forecast.memory_bytes, 0U);
}

TEST(FilmForecast, OfManyWorkers_IsShorter) {
    FilmForecast forecast;
    forecast.pictures = 100;
    forecast.preparation_seconds = 1;
    forecast.seconds_per_picture = 9;
    forecast.serial_per_picture = 1;
    forecast.encoding_seconds = 10;
    EXPECT_DOUBLE_EQ(forecast.cpu_seconds(), 911);
    EXPECT_DOUBLE_EQ(forecast.elapsed_seconds(1, 1), 911);
    EXPECT_DOUBLE_EQ(forecast.elapsed_seconds(1, 2), 501) << "encoded while it renders";
    EXPECT_DOUBLE_EQ(forecast.elapsed_seconds(4, 2), 1 + 25 * 5 + 5);
    EXPECT_DOUBLE_EQ(forecast.elapsed_seconds(1000, 2), 1 + 5 + 5) << "a picture is not shared";
}

TEST(FilmForecast, Sizes_AreThoseOfTheFilm) {
    ForecastFixture film;
    film.shot.sound.is_silent = true;  // film_sound_test.cpp has the size of the sound
    film.shot.render.width = 256;
    film.shot.render.height = 144;
    const FilmForecast forecast = film.forecast("film.mkv");
    (void)make_film(film.shot, film.bake, film.options("film.mkv"), {}, {});
    std::uintmax_t stored = 0;
    for (const auto& entry : fs::recursive_directory_iterator(film.folder.path("cache/frames"))) {
        stored += entry.path().extension() == ".exr" ? entry.file_size() : 0;
    }
    EXPECT_GT(static_cast<double>(forecast.store_bytes), 0.67 * static_cast<double>(stored));
    EXPECT_LT(static_cast<double>(forecast.store_bytes), 1.5 * static_cast<double>(stored));
    const auto written = static_cast<double>(fs::file_size(film.folder.path("film.mkv")));
    EXPECT_GT(static_cast<double>(forecast.film_bytes), 0.5 * written);
    EXPECT_LT(static_cast<double>(forecast.film_bytes), 2 * written);
}

TEST(FilmForecast, OfADenoisedFilm_CountsNoisyFramesAndTheFilter) {
    ForecastFixture film;
    film.shot.sound.is_silent = true;  // film_sound_test.cpp has the size of the sound
    film.shot.render.width = 256;
    film.shot.render.height = 144;
    film.shot.render.samples = 2;
    film.shot.render.for_denoiser = true;
    film.shot.output.denoise.strength = 1;
    const FilmForecast forecast = film.forecast("film.mkv");
    (void)make_film(film.shot, film.bake, film.options("film.mkv"), {}, {});
    std::uintmax_t stored = 0;
    std::uintmax_t noisy = 0;
    for (const auto& entry : fs::recursive_directory_iterator(film.folder.path("cache/frames"))) {
        stored += entry.is_regular_file() ? entry.file_size() : 0;
        noisy += entry.path().extension() == ".noisy" ? entry.file_size() : 0;
    }
    EXPECT_GT(noisy, stored / 2);
    EXPECT_GT(static_cast<double>(forecast.store_bytes), 0.67 * static_cast<double>(stored));
    EXPECT_LT(static_cast<double>(forecast.store_bytes), 1.5 * static_cast<double>(stored));
    const auto written = static_cast<double>(fs::file_size(film.folder.path("film.mkv")));
    EXPECT_GT(static_cast<double>(forecast.film_bytes), 0.7 * written);
    EXPECT_LT(static_cast<double>(forecast.film_bytes), 1.4 * written);
    EXPECT_LE(forecast.serial_per_picture, forecast.seconds_per_picture);
}

TEST(FilmForecast, OfEachKindOfFile_HasASize) {
    ForecastFixture film;
    EXPECT_EQ(film.forecast("").film_bytes, 0U) << "frames are only stored";
    EXPECT_GT(film.forecast("film.####.png").film_bytes, 0U);
    EXPECT_GT(film.forecast("film.####.exr").film_bytes, 0U);
    film.shot.output.codec.reset();
    EXPECT_GT(film.forecast("film.mp4").film_bytes, 0U);
    film.shot.output.bit_rate = 80'000;
    EXPECT_GT(film.forecast("film.mp4").film_bytes, 5000U) << "12 frames of 24 are half a second";
}

TEST(FilmForecast, OfAdaptiveFramesWithChannels_IsPossible) {
    ForecastFixture film;
    film.shot.render.width = 80;  // neither a multiple of a tile nor of a block
    film.shot.render.height = 50;
    film.shot.render.samples = 4;
    film.shot.render.max_samples = 32;
    film.shot.render.noise = 0.02;
    const std::uint64_t without = film.forecast("").store_bytes;
    film.shot.render.aovs = {"depth", "normal", "cryptomatte_object"};
    EXPECT_GT(film.forecast("").store_bytes, without);
}

TEST(FilmForecast, WritesNothing) {
    const ForecastFixture film;
    EXPECT_GT(film.forecast("film.mkv").store_bytes, 0U);
    EXPECT_THAT(film.files(), IsEmpty());
}

TEST(FilmForecast, OfAFilmWithNothingMissing_RendersNothing) {
    const ForecastFixture film;
    (void)make_film(film.shot, film.bake, film.options(""), {}, {});
    const FilmForecast forecast = film.forecast("film.mkv");
    EXPECT_EQ(forecast.frames, 12);
    EXPECT_EQ(forecast.pictures, 0);
    EXPECT_EQ(forecast.store_bytes, 0U);
    EXPECT_EQ(forecast.probe_seconds, 0);
}

TEST(FilmForecast, OfSomeMissingPictures_CountsOnlyThese) {
    const ForecastFixture film;
    FilmJobOptions some = film.options("");
    some.frames = parse_frame_range("0-3");
    (void)make_film(film.shot, film.bake, some, {}, {});
    EXPECT_EQ(film.forecast("film.mkv").pictures, 5);
}

TEST(FilmForecast, StopRequested_Throws) {
    const ForecastFixture film;
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW((void)film.forecast("film.mkv", stop.get_token()), Stopped);
}

TEST(FilmForecast, LimitOfCpuTime_EndsIt) {
    ForecastFixture film;
    film.shot.render.width = 640;
    film.shot.render.height = 360;
    film.shot.render.samples = 65'536;  // hours
    const FilmStatus status = film_status(film.shot, film.bake, film.options(""), {});
    const FilmForecast forecast =
        forecast_film(film.shot, film.bake, status.missing, film.options(""), {},
                      ForecastSettings{.cpu_limit = 0.5});
    EXPECT_EQ(forecast.pictures, 9);
    EXPECT_GT(forecast.cpu_seconds(), forecast.probe_seconds);
    EXPECT_GT(forecast.store_bytes, 0U) << "not one block was finished";
}

}  // namespace
}  // namespace carom::pipeline
