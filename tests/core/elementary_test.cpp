#include "core/elementary.h"

#include <cmath>

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
        ASSERT_NEAR(angle_of(2 * std::cos(angle), 2 * std::sin(angle)), angle, 1e-15) << angle;
    }
    EXPECT_EQ(angle_of(0, 0), 0);
}

}  // namespace
}  // namespace carom
