#include "pipeline/video/tone_curve.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace carom::pipeline {
namespace {

TEST(SrgbEncode, Values_AreThoseOfTheStandard) {
    EXPECT_DOUBLE_EQ(srgb_encode(0), 0);
    EXPECT_NEAR(srgb_encode(1), 1, 1e-15);
    EXPECT_NEAR(srgb_encode(0.0031308), 12.92 * 0.0031308, 1e-15);
    EXPECT_NEAR(srgb_encode(0.0031308000001), 12.92 * 0.0031308, 1e-7);  // the pieces join
    EXPECT_NEAR(srgb_encode(0.2140411404), 0.5, 1e-9);                   // ((0.5 + a)/(1 + a))^2.4
}

TEST(ToneCurve, SrgbTable_IsWithinATwentiethOfASixteenBitStep) {
    const ToneCurve table(srgb_encode, 1.0);
    double worst = 0;
    for (int i = 0; i <= 200000; ++i) {
        const auto x = static_cast<float>(i / 200000.0);
        worst = std::max(
            worst, std::abs(static_cast<double>(table(x)) - srgb_encode(static_cast<double>(x))));
    }
    EXPECT_LT(worst * 65535, 0.05);
}

TEST(ToneCurve, ValuesOutside_AreClamped) {
    const ToneCurve curve([](double x) { return 0.25 + x; }, 2.0);
    EXPECT_EQ(curve(-1.0F), 0.25F);
    EXPECT_EQ(curve(0.0F), 0.25F);
    EXPECT_EQ(curve(2.0F), 2.25F);
    EXPECT_EQ(curve(1e30F), 2.25F);
    EXPECT_EQ(curve(std::numeric_limits<float>::infinity()), 2.25F);
    EXPECT_EQ(curve(std::numeric_limits<float>::quiet_NaN()), 0.25F);
}

TEST(FilmicCurve, MidGreyAndWhite_FollowTheParameters) {
    const FilmicParameters parameters;
    const auto curve = filmic_curve(parameters);
    EXPECT_EQ(curve(0), 0);
    EXPECT_NEAR(curve(parameters.mid_grey), parameters.mid_grey, 1e-12);
    EXPECT_NEAR(curve(parameters.white), 1, 1e-12);
}

TEST(FilmicCurve, Table_FollowsTheFormula) {
    const FilmicParameters parameters;
    const auto curve = filmic_curve(parameters);
    const ToneCurve table(curve, parameters.white);
    for (double x = 1e-5; x < parameters.white; x *= 1.01) {
        ASSERT_NEAR(table(static_cast<float>(x)), curve(x), 2e-6) << x;
    }
}

TEST(FilmicCurve, Curve_RisesEverywhere) {
    const auto curve = filmic_curve(FilmicParameters{});
    double last = -1;
    for (double x = 0; x <= 16; x += 0.001) {
        const double y = curve(x);
        ASSERT_GT(y, last) << x;
        last = y;
    }
}

}  // namespace
}  // namespace carom::pipeline
