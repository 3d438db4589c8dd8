#include "pipeline/video/grain.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace carom::pipeline {
namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 100;

std::vector<std::uint16_t> grainy(double u, std::int64_t frame, double strength = 20) {
    std::vector<std::uint16_t> signal(std::size_t{3} * kWidth * kHeight,
                                      static_cast<std::uint16_t>(std::lround(65535 * u)));
    add_grain(signal, {frame, kWidth, kHeight, 0}, strength);
    return signal;
}

/// The sum of products of deviations from `mean`, each with that `distance` numbers later, per
/// pair.
double covariance(const std::vector<std::uint16_t>& signal, double mean, std::size_t distance) {
    double sum = 0;
    for (std::size_t i = 0; i + distance < signal.size(); ++i) {
        sum += (signal[i] / 65535.0 - mean) * (signal[i + distance] / 65535.0 - mean);
    }
    return sum / static_cast<double>(signal.size() - distance);
}

// Values by another numerical integration.
TEST(GrainVariance, IsThatOfTheBooleanModel) {
    for (const auto& [u, k] :
         {std::pair(0.05, 0.047), std::pair(0.1, 0.0875), std::pair(0.3, 0.190),
          std::pair(0.5, 0.205), std::pair(0.7, 0.147), std::pair(0.9, 0.0435)}) {
        EXPECT_NEAR(grain_variance(u), k, 0.0006) << u;
    }
    EXPECT_EQ(grain_variance(0), 0);
    EXPECT_EQ(grain_variance(1), 0);
}

TEST(Grain, HasTheDeviationOfTheModelAndKeepsTheMean) {
    for (const double u : {0.1, 0.3, 0.5, 0.8}) {
        const auto signal = grainy(u, 7);
        double mean = 0;
        for (const std::uint16_t value : signal) {
            mean += value / 65535.0;
        }
        mean /= static_cast<double>(signal.size());
        const double radius = 20 * 2.4e-5 * kHeight;
        const double deviation = std::sqrt(std::acos(-1.0) * grain_variance(u)) * radius;
        EXPECT_NEAR(mean, u, 4 * deviation / std::sqrt(static_cast<double>(signal.size())));
        EXPECT_NEAR(std::sqrt(covariance(signal, mean, 0)), deviation, 0.03 * deviation) << u;
    }
}

TEST(Grain, IsIndependentInEachPixelChannelAndFrame) {
    const auto signal = grainy(0.5, 3);
    const double variance = covariance(signal, 0.5, 0);
    for (const std::size_t distance : {1U, 2U, 3U, 6U, 3U * kWidth, 3U * kWidth + 3U}) {
        EXPECT_NEAR(covariance(signal, 0.5, distance) / variance, 0, 0.02) << distance;
    }
    const auto next = grainy(0.5, 4);
    double sum = 0;
    for (std::size_t i = 0; i < signal.size(); ++i) {
        sum += (signal[i] / 65535.0 - 0.5) * (next[i] / 65535.0 - 0.5);
    }
    EXPECT_NEAR(sum / static_cast<double>(signal.size()) / variance, 0, 0.02);
    EXPECT_EQ(signal, grainy(0.5, 3)) << "the same frame has the same grain";
}

TEST(Grain, BlackAndWhite_HaveNone) {
    for (const double u : {0.0, 1.0}) {
        const auto signal = grainy(u, 0);
        for (const std::uint16_t value : signal) {
            ASSERT_EQ(value, static_cast<std::uint16_t>(65535 * u));
        }
    }
}

TEST(Grain, InParts_IsThatOfTheWhole) {
    const auto whole = grainy(0.4, 9);
    constexpr int kRows = 37;
    std::vector<std::uint16_t> part(std::size_t{3} * kWidth * (kHeight - kRows),
                                    static_cast<std::uint16_t>(std::lround(65535 * 0.4)));
    add_grain(part, {9, kWidth, kHeight, kRows}, 20);
    EXPECT_TRUE(
        std::equal(part.begin(), part.end(), whole.begin() + std::ptrdiff_t{3} * kWidth * kRows));
}

}  // namespace
}  // namespace carom::pipeline
