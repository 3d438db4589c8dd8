#include "render/sampling/pixel_filter.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "render/sampling/scalar_kernels.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

using scalar::One;

struct Case {
    PixelFilter filter;
    double width;
};

class PixelFilterTest : public testing::TestWithParam<Case> {};

TEST_P(PixelFilterTest, Samples_FollowPdf) {
    const auto [filter, width] = GetParam();
    const PixelFilterSampler sampler(filter, width);
    const int bins = 97;  // not a divisor of the table's size
    const int samples = 300'000;
    std::vector<double> observed(bins, 0.0);
    std::vector<double> expected(bins, 0.0);
    test::TestRandom random(21);
    for (int i = 0; i < samples; ++i) {
        const double x =
            static_cast<double>(scalar::filter_offset<One>(sampler.tables(), random.unit())) /
                width +
            0.5;
        ASSERT_GE(x, 0);
        ASSERT_LE(x, 1);
        observed[static_cast<std::size_t>(std::min(bins - 1.0, x * bins))] += 1;
    }
    double total = 0;
    for (int b = 0; b < bins; ++b) {
        for (int k = 0; k < 32; ++k) {
            const double x = (b + (k + 0.5) / 32) / bins - 0.5;
            expected[static_cast<std::size_t>(b)] +=
                sampler.pdf_1d(x * width) * width / (32 * bins);
        }
        total += expected[static_cast<std::size_t>(b)];
        expected[static_cast<std::size_t>(b)] *= samples;
    }
    EXPECT_NEAR(total, 1, 1e-4);
    EXPECT_GT(test::chi_square_p_value(observed, expected), test::sidak(0.01, 5));
}

INSTANTIATE_TEST_SUITE_P(Filters, PixelFilterTest,
                         testing::Values(Case{PixelFilter::box, 1}, Case{PixelFilter::box, 2.5},
                                         Case{PixelFilter::gaussian, 3},
                                         Case{PixelFilter::blackman_harris, 1.5},
                                         Case{PixelFilter::blackman_harris, 8}));

TEST(PixelFilterSampler, Middle_IsThePixelsCentre) {
    for (const PixelFilter filter :
         {PixelFilter::box, PixelFilter::gaussian, PixelFilter::blackman_harris}) {
        const PixelFilterSampler sampler(filter, 1.5);
        EXPECT_NEAR(scalar::filter_offset<One>(sampler.tables(), 0.5f), 0, 1e-6);
    }
}

TEST(FilterProfile, BlackmanHarris_HasItsPublishedEnds) {
    EXPECT_NEAR(filter_profile(PixelFilter::blackman_harris, 0), 1, 1e-12);
    EXPECT_NEAR(filter_profile(PixelFilter::blackman_harris, 0.5), 6e-5, 1e-12);
    EXPECT_EQ(filter_profile(PixelFilter::blackman_harris, 0.51), 0);
}

}  // namespace
}  // namespace carom::render
