#include "core/elementary_float.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace carom {
namespace {

constexpr float kMost = std::numeric_limits<float>::max();

/// Whether `value` is a neighbour of the nearest float of `exact`, or that float itself.
bool is_near(float value, double exact) {
    const auto nearest = static_cast<float>(exact);
    return value >= std::nextafter(nearest, -kMost) && value <= std::nextafter(nearest, kMost);
}

TEST(FloatExponential_OverItsRange, IsNearest) {
    for (int i = -10300; i <= 8860; ++i) {
        const float x = static_cast<float>(i) * 0.01F;
        ASSERT_TRUE(is_near(exponential(x), std::exp(double{x}))) << x;
    }
    EXPECT_EQ(exponential(0.0F), 1);
    EXPECT_EQ(exponential(-1e9F), 0);
    EXPECT_EQ(exponential(1e9F), HUGE_VALF);
    EXPECT_TRUE(std::isnan(exponential(NAN)));
}

TEST(FloatLogarithm_OverManyMagnitudes, IsNearest) {
    for (int i = -10000; i <= 8800; ++i) {
        const auto x = static_cast<float>(std::exp(i * 0.01));
        ASSERT_TRUE(is_near(logarithm(x), std::log(double{x}))) << x;
        const float next_to_one = 1 + static_cast<float>(i) * 1e-6F;
        ASSERT_TRUE(is_near(logarithm(next_to_one), std::log(double{next_to_one}))) << next_to_one;
    }
    EXPECT_EQ(logarithm(0.0F), -HUGE_VALF);
    EXPECT_EQ(logarithm(HUGE_VALF), HUGE_VALF);
    EXPECT_TRUE(std::isnan(logarithm(-1.0F)));
    EXPECT_TRUE(std::isnan(logarithm(NAN)));
}

TEST(FloatPower_OfManyBasesAndExponents, IsNearest) {
    for (int i = 1; i <= 1000; ++i) {
        const float base = static_cast<float>(i) * 1.3e-3F;
        for (const float exponent : {-2.0F, 0.1F, 1.0F, 2.4F, 20.0F, 300.0F}) {
            const double exact = std::pow(double{base}, double{exponent});
            ASSERT_TRUE(is_near(power(base, exponent), exact)) << base << " to the " << exponent;
        }
    }
    EXPECT_EQ(power(0.0F, 2.0F), 0);
    EXPECT_EQ(power(0.0F, 0.0F), 1);
    EXPECT_EQ(power(0.0F, -1.0F), HUGE_VALF);
    EXPECT_EQ(power(1.0F, 1e30F), 1);
    EXPECT_TRUE(std::isnan(power(-1.0F, 0.5F)));
    EXPECT_TRUE(std::isnan(power(NAN, 0.5F)));
}

TEST(FloatAngle_OfAllDirections, IsNearest) {
    for (int i = -31415; i <= 31415; ++i) {
        const float x = 3 * std::cos(static_cast<float>(i) * 1e-4F);
        const float y = 3 * std::sin(static_cast<float>(i) * 1e-4F);
        ASSERT_TRUE(is_near(arctangent2(y, x), std::atan2(double{y}, double{x}))) << x << ", " << y;
    }
    EXPECT_EQ(arctangent2(0.0F, 0.0F), 0);
    EXPECT_EQ(arctangent2(-1.0F, 0.0F), std::atan2(-1.0F, 0.0F));
    EXPECT_EQ(arctangent2(0.0F, -1.0F), std::atan2(0.0F, -1.0F));
}

TEST(FloatArcSineAndCosine_OverTheirRange, AreNearest) {
    for (int i = -10000; i <= 10000; ++i) {
        const float x = static_cast<float>(i) * 1e-4F;
        ASSERT_TRUE(is_near(arcsine(x), std::asin(double{x}))) << x;
        ASSERT_TRUE(is_near(arccosine(x), std::acos(double{x}))) << x;
    }
}

TEST(FloatErrorFunction_OverItsRange, IsNearest) {
    for (int i = -5000; i <= 5000; ++i) {
        const float x = static_cast<float>(i) * 1e-3F;
        ASSERT_TRUE(is_near(error_function(x), std::erf(double{x}))) << x;
    }
    EXPECT_TRUE(std::isnan(error_function(NAN)));
}

}  // namespace
}  // namespace carom
