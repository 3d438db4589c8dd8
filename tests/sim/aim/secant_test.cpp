// The secant method on misses in closed form.
#include "sim/aim/secant.h"

#include <cmath>

#include <gtest/gtest.h>

namespace carom::sim {
namespace {

TEST(Microdegrees, AreReadBackExactly) {
    for (const std::int64_t number : {0L, 1L, -35'123'457L, 179'999'999L, 180'000'000L}) {
        EXPECT_EQ(to_microdegrees(from_microdegrees(number)), number);
    }
    EXPECT_EQ(to_microdegrees(3.14159265358979), 180'000'000);
}

TEST(SolveDirection, FindsTheRootOfACurveInFewTrials) {
    int trials = 0;
    const Solved solved = solve_direction(0, 1e-6, [&](double at) {
        ++trials;
        Miss miss;
        miss.value = std::tan(at) - 0.5;
        return miss;
    });
    ASSERT_TRUE(solved.direction);
    EXPECT_NEAR(*solved.direction, std::atan(0.5), 1e-6);
    EXPECT_LE(trials, 7);
}

TEST(SolveDirection, TriesWholeMillionthsOfADegree) {
    const Solved solved = solve_direction(0.1, 0, [](double at) {
        EXPECT_EQ(from_microdegrees(to_microdegrees(at)), at);
        Miss miss;
        miss.value = at - 0.123456789;
        return miss;
    });
    EXPECT_EQ(to_microdegrees(*solved.direction), to_microdegrees(0.123456789));
    EXPECT_LT(std::abs(solved.miss), 1e-8);
}

TEST(SolveDirection, HalvesTheIntervalWhereTheSecantLeavesIt) {
    // Flat on both sides of a steep middle, as a ball that touches the jaws.
    const Solved solved = solve_direction(-1, 1e-4, [](double at) {
        Miss miss;
        miss.value = std::atan(1000 * (at - 0.3));
        miss.slope = 0.5;
        return miss;
    });
    ASSERT_TRUE(solved.direction);
    EXPECT_NEAR(*solved.direction, 0.3, 1e-6);
}

TEST(SolveDirection, ComesBackFromWhereNothingIsTouched) {
    const Solved solved = solve_direction(0.5, 1e-6, [](double at) {
        Miss miss;
        if (std::abs(at - 0.2) < 0.01) {
            miss.value = at - 0.204;
        } else {
            miss.too_far = at > 0.2 ? 1 : -1;
            miss.nearer = at - 0.9 * (at - 0.2);
        }
        return miss;
    });
    ASSERT_TRUE(solved.direction);
    EXPECT_NEAR(*solved.direction, 0.204, 1e-6);
}

TEST(SolveDirection, EndsWhereTheMissIsUnknown) {
    int trials = 0;
    const Solved solved = solve_direction(0, 1e-6, [&](double) {
        ++trials;
        Miss miss;
        miss.instead = "it stops";
        return miss;
    });
    EXPECT_FALSE(solved.direction);
    EXPECT_EQ(solved.instead, "it stops");
    EXPECT_EQ(trials, 1);
}

TEST(SolveDirection, WithoutARootEndsWithTheLeastMiss) {
    int trials = 0;
    const Solved solved = solve_direction(0, 1e-6, [&](double at) {
        ++trials;
        Miss miss;
        miss.value = at > 0.1 ? 0.5 + at : -0.25 + at;
        return miss;
    });
    EXPECT_LE(trials, kMostSecants);
    EXPECT_NEAR(*solved.direction, 0.1, 1e-5);
    EXPECT_NEAR(solved.miss, -0.15, 1e-5);
}

}  // namespace
}  // namespace carom::sim
