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

double level_after(double level, double ratio, double quiet) {
    const double pressure = pressure_of(level);
    return level_of(pressure * compressor_gain(pressure, ratio, quiet));
}

TEST(Dynamics, Ratio_DividesTheDistanceFrom80Decibels) {
    for (const double level : {60.0, 80.0, 93.0, 130.0}) {
        for (const double ratio : {1.0, 2.0, 3.0, 4.0}) {
            EXPECT_NEAR(level_after(level, ratio, 60), 80 + (level - 80) / ratio, 1e-10)
                << level << " dB, ratio " << ratio;
        }
    }
    EXPECT_EQ(compressor_gain(0.123, 1, 60), 1);
}

// At 60 dB a ratio of 2 lifts by 10 dB, at 50 dB by half of that, and from 40 dB down not at all.
TEST(Dynamics, QuietSounds_AreLiftedLessAndLess) {
    EXPECT_NEAR(level_after(60, 2, 60), 70, 1e-10);
    EXPECT_NEAR(level_after(50, 2, 60), 55, 1e-10);
    EXPECT_NEAR(level_after(50, 4, 60), 57.5, 1e-10);
    for (const double level : {40.0, 30.0, 0.0}) {
        EXPECT_NEAR(level_after(level, 2, 60), level, 1e-10);
    }
    EXPECT_EQ(compressor_gain(0, 2, 60), 1);
    double last = 0;
    for (double level = 1; level < 120; ++level) {
        const double now = level_after(level, 4, kQuietNoise);
        EXPECT_GT(now, last) << "a louder sound stays louder";
        last = now;
    }
}

}  // namespace
}  // namespace carom::sound
