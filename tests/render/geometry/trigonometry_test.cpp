#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "render/geometry/scalar_kernels.h"

namespace carom::render {
namespace {

using scalar::One;

TEST(SinCosTurn, WholeRange_WithinTwoRoundings) {
    for (int i = -20'000; i <= 20'000; ++i) {
        const float turns = static_cast<float>(i) / 8'000;
        const auto result = scalar::sin_cos_turn<One>(turns);
        const double angle = 2 * std::numbers::pi * static_cast<double>(turns);
        // Three roundings of numbers up to 1, and the angle's own rounding below pi / 4.
        ASSERT_NEAR(result.sine, std::sin(angle), 1.5e-7) << turns;
        ASSERT_NEAR(result.cosine, std::cos(angle), 1.5e-7) << turns;
    }
}

TEST(SinCosTurn, QuarterTurns_AreExact) {
    EXPECT_EQ(scalar::sin_cos_turn<One>(0).sine, 0.f);
    EXPECT_EQ(scalar::sin_cos_turn<One>(0).cosine, 1.f);
    EXPECT_EQ(scalar::sin_cos_turn<One>(0.25f).sine, 1.f);
    EXPECT_EQ(scalar::sin_cos_turn<One>(0.25f).cosine, 0.f);
    EXPECT_EQ(scalar::sin_cos_turn<One>(0.5f).cosine, -1.f);
    EXPECT_EQ(scalar::sin_cos_turn<One>(0.75f).sine, -1.f);
}

TEST(QuickAngle, WholeCircle_IsWithinThreeRoundings) {
    for (int i = -5000; i <= 5000; ++i) {
        const double angle = std::numbers::pi * i / 5000;
        for (const double size : {1e-6, 1.0, 1e6}) {
            const auto x = static_cast<float>(size * std::cos(angle));
            const auto y = static_cast<float>(size * std::sin(angle));
            const double expected = std::atan2(static_cast<double>(y), static_cast<double>(x));
            ASSERT_NEAR(scalar::quick_angle<scalar::One>(x, y), expected, 3.5e-7) << angle;
        }
    }
    EXPECT_EQ(scalar::quick_angle<scalar::One>(0, 0), 0.f);
}

TEST(QuickArccosine, WholeRange_IsWithinThreeRoundings) {
    for (int i = -10'000; i <= 10'000; ++i) {
        const float cosine = static_cast<float>(i) / 10'000;
        ASSERT_NEAR(scalar::quick_arccosine<scalar::One>(cosine),
                    std::acos(static_cast<double>(cosine)), 3.5e-7)
            << cosine;
    }
}

}  // namespace
}  // namespace carom::render
