#include "sound/level/decibels.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace carom::sound {
namespace {

TEST(Decibels, PressuresAndFactors_AreThoseOfTheDefinition) {
    EXPECT_NEAR(factor_of(20), 10, 1e-13);
    EXPECT_NEAR(factor_of(-6), 0.50118723362727228, 1e-15);
    EXPECT_NEAR(decibels_of(10), 20, 1e-13);
    EXPECT_NEAR(level_of(1), 93.979400086720376, 1e-12);
    EXPECT_NEAR(pressure_of(120), 20, 1e-12);
    EXPECT_EQ(level_of(0), -std::numeric_limits<double>::infinity());
}

TEST(Dynamics, Ratio_DividesTheDistanceFrom80Decibels) {
    for (const double level : {0.0, 40.0, 80.0, 93.0, 130.0}) {
        for (const double ratio : {1.0, 2.0, 3.0, 4.0}) {
            const double pressure = pressure_of(level);
            EXPECT_NEAR(level_of(pressure * dynamics_factor(pressure, ratio)),
                        80 + (level - 80) / ratio, 1e-10)
                << level << " dB, ratio " << ratio;
        }
    }
    EXPECT_EQ(dynamics_factor(0.123, 1), 1);
}

TEST(Dynamics, Silence_HasTheFactorOfZeroDecibels) {
    EXPECT_EQ(dynamics_factor(0, 2), dynamics_factor(kReferencePressure, 2));
    EXPECT_NEAR(dynamics_factor(0, 2), 100, 1e-10);
}

}  // namespace
}  // namespace carom::sound
