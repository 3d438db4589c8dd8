#include "sim/numeric/polynomial.h"

#include <gtest/gtest.h>

namespace carom::sim {
namespace {

/// (t - a)(t - b)(t - c)(t - d)
Quartic with_roots(double a, double b, double c, double d) {
    return {a * b * c * d, -(a * b * c + a * b * d + a * c * d + b * c * d),
            a * b + a * c + a * d + b * c + b * d + c * d, -(a + b + c + d), 1};
}

TEST(Polynomial_FourRealRoots, AreAllFoundInOrder) {
    std::array<double, 4> roots{};
    ASSERT_EQ(sign_changes(with_roots(0.1, 0.2, 1.5, 3), 0, 10, roots), 4U);
    EXPECT_NEAR(roots[0], 0.1, 1e-14);
    EXPECT_NEAR(roots[1], 0.2, 1e-14);
    EXPECT_NEAR(roots[2], 1.5, 1e-13);
    EXPECT_NEAR(roots[3], 3, 1e-13);
}

TEST(Polynomial_RootsOutsideTheBracket, AreNotReturned) {
    std::array<double, 4> roots{};
    ASSERT_EQ(sign_changes(with_roots(-1, 0.5, 2, 4), 0, 1, roots), 1U);
    EXPECT_NEAR(roots[0], 0.5, 1e-14);
}

TEST(FirstDescent_FromAbove, SkipsTheAscent) {
    // Positive before 1, negative in (1, 2), positive after: the first descent is at 1.
    const auto t = first_descent(with_roots(1, 2, -1, -2), 0, 5);
    ASSERT_TRUE(t);
    EXPECT_NEAR(*t, 1, 1e-14);
    // From inside (1, 2) it rises first and never falls again.
    EXPECT_FALSE(first_descent(with_roots(1, 2, -1, -2), 1.5, 5));
}

TEST(FirstDescent_LowerDegrees, AreHandled) {
    EXPECT_FALSE(first_descent({1, 0, 0, 0, 0}, 0, 1));
    EXPECT_DOUBLE_EQ(first_descent({1, -2, 0, 0, 0}, 0, 1).value(), 0.5);
    EXPECT_NEAR(first_descent({2, -3, 1, 0, 0}, 0, 5).value(), 1, 1e-15);
    EXPECT_FALSE(first_descent({1, -2, 0, 0, 0}, 0, 0.4));
}

}  // namespace
}  // namespace carom::sim
