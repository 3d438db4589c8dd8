#include "tests/render/statistics.h"

#include <gtest/gtest.h>

namespace carom::test {
namespace {

// Critical values of the chi-square distribution, Abramowitz and Stegun 1964, table 26.8.
TEST(ChiSquareTail, Tabulated_MatchesAbramowitzStegun) {
    EXPECT_NEAR(chi_square_tail(3.841459, 1), 0.05, 1e-7);
    EXPECT_NEAR(chi_square_tail(18.3070, 10), 0.05, 1e-6);
    EXPECT_NEAR(chi_square_tail(15.9871792, 10), 0.10, 1e-6);
    EXPECT_NEAR(chi_square_tail(135.807, 100), 0.01, 1e-5);
    EXPECT_NEAR(chi_square_tail(67.3276, 100), 0.995, 1e-5);
}

TEST(ChiSquarePValue, UniformCounts_PValuesAreUniform) {
    TestRandom random(3);
    int below_tenth = 0;
    for (int repeat = 0; repeat < 400; ++repeat) {
        std::vector<double> observed(20, 0.0);
        const std::vector<double> expected(20, 50.0);
        for (int i = 0; i < 1000; ++i) {
            observed[random.next() % 20] += 1;
        }
        below_tenth += chi_square_p_value(observed, expected) < 0.1 ? 1 : 0;
    }
    EXPECT_NEAR(below_tenth, 40, 4 * 6);
}

TEST(ChiSquarePValue, WrongCounts_Rejected) {
    const std::vector<double> expected(10, 1000.0);
    std::vector<double> observed = expected;
    observed[3] += 200;
    observed[7] -= 200;
    EXPECT_LT(chi_square_p_value(observed, expected), 1e-6);
    const std::vector<double> with_hole = {0, 1000, 1000};
    EXPECT_EQ(chi_square_p_value(std::vector<double>{1, 1000, 999}, with_hole), 0);
}

}  // namespace
}  // namespace carom::test
