#include "pipeline/study/sampling.h"

#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/elementary.h"
#include "core/normal.h"

namespace carom::pipeline::study {
namespace {

using ::testing::ElementsAre;

std::vector<double> first_numbers(std::size_t dimension, std::uint32_t count) {
    std::vector<double> numbers;
    for (std::uint32_t i = 0; i < count; ++i) {
        numbers.push_back(sobol_number(i, dimension) * 0x1p-32);
    }
    return numbers;
}

TEST(Sobol_FirstPoints, AreThoseOfJoeAndKuo) {
    // In the order of the index; their program prints that of its Gray code.
    EXPECT_THAT(first_numbers(0, 8), ElementsAre(0, 0.5, 0.25, 0.75, 0.125, 0.625, 0.375, 0.875));
    EXPECT_THAT(first_numbers(1, 8), ElementsAre(0, 0.5, 0.75, 0.25, 0.625, 0.125, 0.375, 0.875));
    EXPECT_THAT(first_numbers(2, 8), ElementsAre(0, 0.5, 0.75, 0.25, 0.375, 0.875, 0.625, 0.125));
}

TEST(Sobol_EachDimension, HasOnePointInEachIntervalOfAPowerOfTwo) {
    for (std::size_t d = 0; d < kMostSobolDimensions; ++d) {
        std::set<std::uint32_t> intervals;
        for (std::uint32_t i = 0; i < 1024; ++i) {
            intervals.insert(sobol_number(i, d) >> 22U);
        }
        EXPECT_EQ(intervals.size(), 1024U) << d;
    }
    EXPECT_NE(sobol_number(0xFFFFFFFFU, 3), 0U);
}

TEST(Sobol_FirstTwoDimensions, FillEachElementaryRectangle) {
    for (unsigned across = 0; across <= 8; ++across) {
        std::set<std::pair<std::uint32_t, std::uint32_t>> rectangles;
        for (std::uint32_t i = 0; i < 256; ++i) {
            const std::uint64_t x = sobol_number(i, 0);
            const std::uint64_t y = sobol_number(i, 1);
            rectangles.emplace(static_cast<std::uint32_t>(x >> (32U - across)),
                               static_cast<std::uint32_t>(y >> (24U + across)));
        }
        EXPECT_EQ(rectangles.size(), 256U) << across;
    }
}

TEST(LatinHypercube, HasOnePointInEachIntervalOfEachDimension) {
    constexpr std::size_t kCount = 57;
    const auto points = sample_points(Sampling::latin, kCount, 4, 3);
    for (std::size_t d = 0; d < 4; ++d) {
        std::set<int> intervals;
        for (const std::vector<double>& point : points) {
            intervals.insert(static_cast<int>(point[d] * kCount));
        }
        EXPECT_EQ(intervals.size(), kCount);
        EXPECT_EQ(*intervals.begin(), 0);
        EXPECT_EQ(*intervals.rbegin(), static_cast<int>(kCount) - 1);
    }
    EXPECT_NE(points[0][0], points[0][1]);
}

TEST(SamplePoints, DependOnTheSeedAloneAndAreInside) {
    for (const Sampling sampling : {Sampling::sobol, Sampling::latin, Sampling::random}) {
        const auto points = sample_points(sampling, 100, 3, 7);
        EXPECT_EQ(points, sample_points(sampling, 100, 3, 7));
        EXPECT_NE(points, sample_points(sampling, 100, 3, 8));
        double sum = 0;
        for (const std::vector<double>& point : points) {
            for (const double x : point) {
                EXPECT_GT(x, 0);
                EXPECT_LT(x, 1);
                sum += x;
            }
        }
        EXPECT_NEAR(sum / 300, 0.5, 0.06);
    }
}

TEST(NormalQuantile, IsTheInverseOfTheErrorFunction) {
    for (const double p : {1e-12, 1e-6, 0.001, 0.02425, 0.07, 0.075, 0.3, 0.5, 0.7, 0.93, 0.999}) {
        const double x = normal_quantile(p);
        EXPECT_NEAR((1 + error_function(x / std::sqrt(2.0))) / 2, p, 1e-14) << p;
        EXPECT_NEAR(normal_quantile(1 - p), -x, std::abs(x) * 1e-4) << p;
    }
    EXPECT_EQ(normal_quantile(0.5), 0);
    // Digits of tables of the normal distribution.
    EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-14);
    EXPECT_NEAR(normal_quantile(1e-10), -6.361340902404056, 1e-12);
    EXPECT_NEAR(normal_quantile(0x1p-33), -6.338, 1e-3);
}

}  // namespace
}  // namespace carom::pipeline::study
