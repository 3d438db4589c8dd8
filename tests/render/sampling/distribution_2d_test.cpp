#include "render/sampling/distribution_2d.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "render/sampling/scalar_kernels.h"
#include "tests/render/statistics.h"

namespace carom::render {
namespace {

using scalar::One;

scalar::UvSampleOf<One> sample(const Distribution2D& distribution, const V2f& u) {
    return scalar::sample_piecewise_constant<One>(distribution.tables(), u);
}
float pdf(const Distribution2D& distribution, const V2f& uv) {
    return scalar::pdf_piecewise_constant<One>(distribution.tables(), uv);
}

std::vector<float> varied_weights(int width, int height) {
    std::vector<float> weights;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            // Dark rows, dark columns and one very bright cell, as in a sky with a sun.
            const bool dark = y == 2 || x == 4;
            const float value = static_cast<float>(1 + x * y);
            weights.push_back(dark ? 0 : (x == 3 && y == 5 ? 500 : value));
        }
    }
    return weights;
}

TEST(Distribution2D, Samples_FollowWeights) {
    const int width = 9;
    const int height = 7;
    const std::vector<float> weights = varied_weights(width, height);
    const Distribution2D distribution(weights, width, height);
    double total = 0;
    for (const float w : weights) {
        total += static_cast<double>(w);
    }
    // Four quarters of each cell, so that the position within a cell is tested, too.
    const int samples = 400'000;
    std::vector<double> observed(weights.size() * 4, 0.0);
    std::vector<double> expected;
    for (const float w : weights) {
        expected.insert(expected.end(), 4, samples * static_cast<double>(w) / total / 4);
    }
    test::TestRandom random(12);
    for (int i = 0; i < samples; ++i) {
        const float u = random.unit();
        const float v = random.unit();
        const auto s = sample(distribution, V2f(u, v));
        ASSERT_GT(s.pdf, 0);
        ASSERT_EQ(s.pdf, pdf(distribution, s.uv));
        const float x = s.uv.x * static_cast<float>(width);
        const float y = s.uv.y * static_cast<float>(height);
        const std::size_t cell = static_cast<std::size_t>(y) * 9 + static_cast<std::size_t>(x);
        const std::size_t quarter =
            (std::fmod(x, 1.f) < 0.5f ? 0u : 1u) + (std::fmod(y, 1.f) < 0.5f ? 0u : 2u);
        observed[4 * cell + quarter] += 1;
    }
    EXPECT_GT(test::chi_square_p_value(observed, expected), 1e-3);
}

TEST(Distribution2D, Pdf_IntegratesToOne) {
    const Distribution2D distribution(varied_weights(9, 7), 9, 7);
    double sum = 0;
    for (int y = 0; y < 7; ++y) {
        for (int x = 0; x < 9; ++x) {
            sum += static_cast<double>(pdf(distribution, V2f((static_cast<float>(x) + 0.5f) / 9,
                                                             (static_cast<float>(y) + 0.5f) / 7)));
        }
    }
    EXPECT_NEAR(sum / 63, 1, 1e-6);
    EXPECT_EQ(pdf(distribution, V2f(0.5f, 1)), 0);
}

TEST(Distribution2D, NoWeight_HasNoDensity) {
    const std::vector<float> zeros(12, 0.f);
    const Distribution2D distribution(zeros, 4, 3);
    EXPECT_FALSE(distribution.tables().density.exists());
    EXPECT_EQ(distribution.mean(), 0);
}

TEST(Distribution2D, BadWeights_CountAsZero) {
    const std::vector<float> weights = {1, std::numeric_limits<float>::quiet_NaN(), -3,
                                        std::numeric_limits<float>::infinity()};
    const Distribution2D distribution(weights, 2, 2);
    test::TestRandom random(4);
    for (int i = 0; i < 1000; ++i) {
        const float u = random.unit();
        const float v = random.unit();
        const auto s = sample(distribution, V2f(u, v));
        ASSERT_LT(s.uv.x, 0.5f);
        ASSERT_LT(s.uv.y, 0.5f);
        ASSERT_EQ(s.pdf, 4);
    }
}

TEST(Distribution2D, LargestNumbers_StayInRange) {
    const float last = 0x1.fffffep-1f;
    const Distribution2D distribution(varied_weights(9, 7), 9, 7);
    const auto s = sample(distribution, V2f(last, last));
    EXPECT_LT(s.uv.x, 1);
    EXPECT_LT(s.uv.y, 1);
    EXPECT_GT(s.pdf, 0);
}

}  // namespace
}  // namespace carom::render
