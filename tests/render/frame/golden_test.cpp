// Noisy pictures against stored means and variances: a Z-test for each pixel and channel, and a
// chi-square test over all pixels of a channel (Subr and Arvo 2007, "Statistical hypothesis testing
// for assessing Monte Carlo estimators").
//
// CAROM_WRITE_GOLDEN=1 writes new references, which only a change that is meant to change pictures
// may do.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "render/film/image_file.h"
#include "tests/folders.h"
#include "tests/render/frame/golden_scenes.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

namespace fs = std::filesystem;

constexpr int kReferenceRuns = 256;
constexpr int kRuns = 16;
constexpr std::uint64_t kReferenceSeed = 1'000'000;  // far from the seeds of the test

const fs::path kFolder = fs::path(CAROM_SOURCE_DIR) / "tests/render/golden";

/// Red, green and blue of every pixel: mean over runs, and the variance of one run.
struct Picture {
    std::vector<double> mean, variance;
};

Picture picture_of(const test::GoldenScene& golden, int runs, std::uint64_t first_seed) {
    const PreparedScene prepared(golden.scene, golden.settings);
    std::vector<double> sum;
    std::vector<double> squares;
    for (int run = 0; run < runs; ++run) {
        FrameInput frame = golden.frame;
        frame.seed = first_seed + static_cast<std::uint64_t>(run);
        const Film film = render_frame(prepared, golden.tracks, frame, golden.settings);
        sum.resize(film.rgba.size() / 4 * 3);
        squares.resize(sum.size());
        for (std::size_t i = 0; i < sum.size(); ++i) {
            const auto value = static_cast<double>(film.rgba[i / 3 * 4 + i % 3]);
            sum[i] += value;
            squares[i] += value * value;
        }
    }
    Picture picture;
    for (std::size_t i = 0; i < sum.size(); ++i) {
        const double mean = sum[i] / runs;
        picture.mean.push_back(mean);
        picture.variance.push_back(std::max(0.0, squares[i] / runs - mean * mean) * runs /
                                   (runs - 1));
    }
    return picture;
}

/// A line per pixel: mean and variance of each channel.
void write(const Picture& picture, const fs::path& path) {
    std::ofstream file(path);
    file.precision(7);
    for (std::size_t i = 0; i < picture.mean.size(); ++i) {
        file << picture.mean[i] << ' ' << picture.variance[i] << (i % 3 == 2 ? '\n' : ' ');
    }
}

Picture read(const fs::path& path) {
    std::ifstream file(path);
    Picture picture;
    double mean = 0;
    double variance = 0;
    while (file >> mean >> variance) {
        picture.mean.push_back(mean);
        picture.variance.push_back(variance);
    }
    return picture;
}

/// Saves the pictures for a developer who looks for the error.
void save(const test::GoldenScene& golden, const std::string& what,
          const std::vector<double>& values) {
    Film film;
    film.width = golden.settings.width;
    film.height = golden.settings.height;
    for (std::size_t i = 0; i < values.size(); i += 3) {
        for (std::size_t c = 0; c < 3; ++c) {
            film.rgba.push_back(static_cast<float>(values[i + c]));
        }
        film.rgba.push_back(1);
    }
    const fs::path folder = fs::path(CAROM_BINARY_DIR) / "golden";
    fs::create_directories(folder);
    write_exr(film, (folder / (golden.name + "_" + what + ".exr")).string());
}

class GoldenPicture : public testing::TestWithParam<test::GoldenScene> {};

TEST_P(GoldenPicture, Pixels_HaveTheStoredMeans) {
    const test::GoldenScene& golden = GetParam();
    const fs::path path = kFolder / (golden.name + ".txt");
    if (std::getenv("CAROM_WRITE_GOLDEN") != nullptr) {
        write(picture_of(golden, kReferenceRuns, kReferenceSeed), path);
    }
    const Picture reference = read(path);
    const Picture found = picture_of(golden, kRuns, 1);
    ASSERT_EQ(reference.mean.size(), found.mean.size()) << path;
    double sums[3] = {0, 0, 0};
    std::vector<double> z_values;
    for (std::size_t i = 0; i < found.mean.size(); ++i) {
        const double difference = found.mean[i] - reference.mean[i];
        // The larger of both: a rare bright sample may be in only one of them.
        const double variance = std::max(reference.variance[i], found.variance[i]) *
                                (1.0 / kRuns + 1.0 / kReferenceRuns);
        const double rounding = 2e-6 * (1 + std::abs(reference.mean[i]));
        const double z = difference / std::sqrt(variance + rounding * rounding);
        z_values.push_back(z);
        sums[i % 3] += z * z;
    }
    const auto pixels = static_cast<double>(z_values.size() / 3);
    for (const double sum : sums) {
        EXPECT_GT(test::chi_square_tail(sum, pixels), 1e-4)
            << golden.name << ": mean square of z " << sum / pixels << " over " << pixels
            << " pixels";
    }
    for (const double z : z_values) {
        EXPECT_LT(std::abs(z), 5) << golden.name;
    }
    if (HasFailure()) {
        save(golden, "found", found.mean);
        save(golden, "reference", reference.mean);
        save(golden, "z", z_values);
    }
}

INSTANTIATE_TEST_SUITE_P(All, GoldenPicture, testing::ValuesIn(test::golden_scenes()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace carom::render
