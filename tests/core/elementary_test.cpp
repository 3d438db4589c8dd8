#include "core/elementary.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace carom {
namespace {

TEST(SinCos_OverManyTurns, AgreesWithTheLibrary) {
    for (int i = -20000; i <= 20000; ++i) {
        const double angle = i * 0.37;
        const SinCos own = sin_cos(angle);
        ASSERT_NEAR(own.sin, std::sin(angle), 4e-16) << angle;
        ASSERT_NEAR(own.cos, std::cos(angle), 4e-16) << angle;
    }
}

TEST(SinCos_OfVeryLargeAngles, IsThatOfANeighbouringAngle) {
    for (const double angle : {1.1e6, -3e7, 8e9}) {
        const SinCos own = sin_cos(angle);
        EXPECT_NEAR(own.sin, std::sin(angle), 1e-16 * std::abs(angle));
        EXPECT_NEAR(own.cos, std::cos(angle), 1e-16 * std::abs(angle));
    }
    for (const double angle : {1e24, -1e300}) {
        const SinCos own = sin_cos(angle);
        EXPECT_NEAR(own.sin * own.sin + own.cos * own.cos, 1, 1e-15);
    }
}

TEST(SinCos_OfInfinity, IsNotANumber) {
    for (const double angle : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
        EXPECT_TRUE(std::isnan(sin_cos(angle).sin));
        EXPECT_TRUE(std::isnan(sin_cos(angle).cos));
    }
}

TEST(Exponential_OverItsRange, AgreesWithTheLibrary) {
    for (int i = -6990; i <= 6990; ++i) {
        const double x = i * 0.1;
        ASSERT_NEAR(exponential(x) / std::exp(x), 1, 1e-15) << x;
    }
    EXPECT_EQ(exponential(0), 1);
    EXPECT_EQ(exponential(-1e9), 0);
}

TEST(AngleOf_AllDirections, AgreesWithTheLibrary) {
    for (int i = -3141; i <= 3141; ++i) {
        const double angle = i * 1e-3;
        ASSERT_NEAR(arctangent2(2 * std::sin(angle), 2 * std::cos(angle)), angle, 1e-15) << angle;
    }
    EXPECT_EQ(arctangent2(0, 0), 0);
}

TEST(ArcSineAndCosine_OverTheirRange, AgreeWithTheLibrary) {
    for (int i = -1000; i <= 1000; ++i) {
        const double x = i * 1e-3;
        ASSERT_NEAR(arcsine(x), std::asin(x), 1e-15) << x;
        ASSERT_NEAR(arccosine(x), std::acos(x), 1e-15) << x;
    }
}

TEST(Logarithms_OverManyMagnitudes, AgreeWithTheLibrary) {
    for (int i = -7000; i <= 7000; ++i) {
        const double x = std::exp(i * 0.1001);
        ASSERT_NEAR(logarithm(x), std::log(x), 1e-15 * std::abs(std::log(x))) << x;
        ASSERT_NEAR(logarithm2(x), std::log2(x), 1e-15 * std::abs(std::log2(x))) << x;
    }
    for (int i = -1000; i <= 1000; ++i) {  // near 1, where the logarithm is small
        const double x = 1 + i * 1e-7;
        ASSERT_NEAR(logarithm(x), std::log(x), 1e-15 * std::abs(std::log(x))) << x;
    }
}

TEST(Logarithms_AtTheEdges, AreInfiniteOrNotANumber) {
    EXPECT_EQ(logarithm(1), 0);
    EXPECT_EQ(logarithm(0), -HUGE_VAL);
    EXPECT_EQ(logarithm2(HUGE_VAL), HUGE_VAL);
    EXPECT_TRUE(std::isnan(logarithm(-1)));
    EXPECT_TRUE(std::isnan(logarithm2(std::nan(""))));
    EXPECT_NEAR(logarithm(std::numeric_limits<double>::denorm_min()),
                std::log(std::numeric_limits<double>::denorm_min()), 1e-12);
}

TEST(PowersOfTwo_OfWholeNumbers, AreExact) {
    for (int i = -1000; i <= 1000; ++i) {
        ASSERT_EQ(exponential2(i), std::ldexp(1.0, i));
        ASSERT_EQ(logarithm2(std::ldexp(1.0, i)), i);
        const double between = 0.99 * i + 0.37;
        ASSERT_NEAR(exponential2(between) / std::exp2(between), 1, 1e-15) << between;
    }
    EXPECT_EQ(exponential2(-2000), 0);
    EXPECT_EQ(exponential2(2000), HUGE_VAL);
    EXPECT_TRUE(std::isnan(exponential2(std::nan(""))));
}

TEST(Power_OfManyBasesAndExponents, AgreesWithTheLibrary) {
    for (int i = 1; i <= 200; ++i) {
        const double base = i * 0.017;
        for (const double exponent : {-3.5, 1 / 2.4, 1.0, 2.4, 78.84375}) {
            const double error = 1e-15 * (1 + std::abs(exponent * std::log(base)));
            ASSERT_NEAR(power(base, exponent) / std::pow(base, exponent), 1, error)
                << base << " to the " << exponent;
        }
    }
    EXPECT_EQ(power(0, 2.4), 0);
    EXPECT_EQ(power(0, 0), 1);
    EXPECT_EQ(power(0, -1), HUGE_VAL);
    EXPECT_EQ(power(1, 1e300), 1);
    EXPECT_TRUE(std::isnan(power(-1, 0.5)));
}

TEST(ErrorFunction_OverItsRange, AgreesWithTheLibrary) {
    for (int i = -700; i <= 700; ++i) {
        const double x = i * 0.01;
        ASSERT_NEAR(error_function(x), std::erf(x), 4e-15) << x;
    }
    EXPECT_EQ(error_function(HUGE_VAL), 1);
    EXPECT_TRUE(std::isnan(error_function(std::nan(""))));
}

}  // namespace
}  // namespace carom
