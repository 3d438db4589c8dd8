#include "render/geometry/trigonometry.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace carom::render {
namespace {

TEST(SinCosTurn, WholeRange_WithinTwoRoundings) {
    for (int i = -20'000; i <= 20'000; ++i) {
        const float turns = static_cast<float>(i) / 8'000;
        const SinCos result = sin_cos_turn(turns);
        const double angle = 2 * std::numbers::pi * static_cast<double>(turns);
        // Three roundings of numbers up to 1, and the angle's own rounding below pi / 4.
        ASSERT_NEAR(result.sine, std::sin(angle), 1.5e-7) << turns;
        ASSERT_NEAR(result.cosine, std::cos(angle), 1.5e-7) << turns;
    }
}

TEST(SinCosTurn, QuarterTurns_AreExact) {
    EXPECT_EQ(sin_cos_turn(0).sine, 0.f);
    EXPECT_EQ(sin_cos_turn(0).cosine, 1.f);
    EXPECT_EQ(sin_cos_turn(0.25f).sine, 1.f);
    EXPECT_EQ(sin_cos_turn(0.25f).cosine, 0.f);
    EXPECT_EQ(sin_cos_turn(0.5f).cosine, -1.f);
    EXPECT_EQ(sin_cos_turn(0.75f).sine, -1.f);
}

}  // namespace
}  // namespace carom::render
