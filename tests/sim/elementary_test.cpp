#include "sim/numeric/elementary.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/numeric/rotation.h"

namespace carom::sim {
namespace {

TEST(SinCos_OverManyTurns, AgreesWithTheLibrary) {
    for (int i = -20000; i <= 20000; ++i) {
        const double angle = i * 0.37;
        const SinCos own = sin_cos(angle);
        ASSERT_NEAR(own.sin, std::sin(angle), 4e-16) << angle;
        ASSERT_NEAR(own.cos, std::cos(angle), 4e-16) << angle;
    }
}

TEST(SinCos_OfVeryLargeAngles, IsThatOfANeighbour) {
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

TEST(Turned_ConstantSpin, IsExactOverManyTurns) {
    const Vec3 omega(0, 0, 70);
    const Quat q = turned(Quat(), omega, omega, 10);
    EXPECT_NEAR(q.r, std::cos(350.0), 1e-13);
    EXPECT_NEAR(q.v.z, std::sin(350.0), 1e-13);
}

TEST(Turned_TurningAxis, AgreesWithFineSteps) {
    const Vec3 from(30, -20, 10);
    const Vec3 to(-10, 40, 5);
    const double duration = 0.5;
    Quat fine;
    const int count = 200000;
    for (int i = 0; i < count; ++i) {
        const Vec3 omega = from + (to - from) * ((i + 0.5) / count);
        fine = rotation_by(omega * (duration / count)) * fine;
    }
    const Quat own = turned(Quat(), from, to, duration);
    const double cosine = own.r * fine.r + own.v.dot(fine.v);
    EXPECT_NEAR(std::abs(cosine), 1, 1e-9);  // under 0.005 degree
}

}  // namespace
}  // namespace carom::sim
