#include "pipeline/camera/rational.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/camera/wide_rational.h"

namespace carom::pipeline {
namespace {

TEST(Rational, Construction_ReducesAndMovesTheSignToTheNumerator) {
    const Rational value(6, -8);
    EXPECT_EQ(value.numerator(), -3);
    EXPECT_EQ(value.denominator(), 4);
    EXPECT_EQ(Rational(0, -5), Rational(0));
    EXPECT_THROW(Rational(1, 0), Error);
}

TEST(Rational, Arithmetic_IsExact) {
    const Rational ntsc(24000, 1001);
    EXPECT_EQ(Rational(1, 3) + Rational(1, 6), Rational(1, 2));
    EXPECT_EQ(Rational(1, 3) - Rational(1, 2), Rational(-1, 6));
    EXPECT_EQ(Rational(2, 3) * Rational(9, 4), Rational(3, 2));
    EXPECT_EQ(Rational(1) / ntsc, Rational(1001, 24000));
    EXPECT_EQ(Rational(1) / Rational(-2), Rational(-1, 2));
    EXPECT_THROW(ntsc / Rational(0), Error);
}

TEST(Rational, Order_IsExactWhereDoublesAreEqual) {
    const std::int64_t big = std::int64_t{1} << 60;
    const Rational less(big - 1, big), more(big, big + 1);
    EXPECT_EQ(less.to_double(), more.to_double());
    EXPECT_TRUE(less < more);
    EXPECT_FALSE(more < less);
    EXPECT_TRUE(more <= more);
    EXPECT_TRUE(Rational(-1, 2) < Rational(-1, 3));
}

TEST(Rational, Overflow_IsAnErrorNotAWrongValue) {
    const std::int64_t largest = std::numeric_limits<std::int64_t>::max();
    EXPECT_THROW(Rational(largest) + Rational(1), Error);
    EXPECT_THROW(Rational(1, largest) * Rational(1, 3), Error);
    EXPECT_THROW(Rational(-largest) - Rational(largest), Error);
    EXPECT_EQ(Rational(largest, 3) * Rational(3, largest), Rational(1));
    // Three factors of 2^62 exceed 128 bits, too.
    const WideRational wide(Int128{1} << 62, 1);
    EXPECT_NO_THROW(wide * wide);
    EXPECT_THROW(wide * wide * wide, Error);
}

TEST(Rational, Text_IsAWholeNumberOrAFraction) {
    EXPECT_EQ(Rational(24).to_string(), "24");
    EXPECT_EQ(Rational(24000, 1001).to_string(), "24000/1001");
    EXPECT_EQ(Rational(-1, 2).to_string(), "-1/2");
}

TEST(Rational, Nearest_FindsTheFractionThatWasMeant) {
    EXPECT_EQ(Rational::nearest(1.0 / 48), Rational(1, 48));
    EXPECT_EQ(Rational::nearest(24000.0 / 1001), Rational(24000, 1001));
    EXPECT_EQ(Rational::nearest(29.97), Rational(2997, 100));
    EXPECT_EQ(Rational::nearest(-0.1), Rational(-1, 10));
    EXPECT_EQ(Rational::nearest(3.3), Rational(33, 10));
    EXPECT_EQ(Rational::nearest(3600), Rational(3600));
    EXPECT_EQ(Rational::nearest(0), Rational(0));
    EXPECT_EQ(Rational::nearest(1e-9), Rational(1, 1'000'000'000));
    EXPECT_EQ(Rational::nearest(1e15), Rational(1'000'000'000'000'000));
}

TEST(Rational, Nearest_StaysWithinItsBound) {
    for (const double value : {std::sqrt(2.0), 1234.56789012345, 0.000123456789, 3.14159265358979,
                               -0.999999999999, 7e-10, 1 / 3.0 + 1e-11}) {
        const Rational found = Rational::nearest(value);
        EXPECT_LE(std::fabs(found.to_double() - value), 1.0001e-12 * std::fabs(value)) << value;
        EXPECT_LT(found.denominator(), 2'000'000'000'000) << value;
    }
    EXPECT_THROW((void)Rational::nearest(std::numeric_limits<double>::infinity()), Error);
    EXPECT_THROW((void)Rational::nearest(std::nan("")), Error);
    EXPECT_THROW((void)Rational::nearest(1e300), Error);
    EXPECT_THROW((void)Rational::nearest(1e-300), Error);
}

TEST(Rational, ToDouble_IsTheNearestDouble) {
    for (std::int64_t n = -500; n <= 500; ++n) {
        EXPECT_EQ(Rational(n, 192).to_double(), static_cast<double>(n) / 192);
    }
    // 2^60 + 2^7 lies halfway between two doubles and rounds to the even one; a slightly larger
    // value rounds up.
    const std::int64_t base = std::int64_t{1} << 60;
    EXPECT_EQ(Rational(base + 128).to_double(), 0x1p60);
    EXPECT_EQ(Rational(base + 129).to_double(), 0x1p60 + 256);
    EXPECT_EQ(WideRational(3 * (Int128{base} + 128) + 1, 3).to_double(), 0x1p60 + 256);
}

TEST(Rational, FloorAndCeil_RoundTowardsInfinities) {
    EXPECT_EQ(WideRational(7, 2).floor(), 3);
    EXPECT_EQ(WideRational(7, 2).ceil(), 4);
    EXPECT_EQ(WideRational(-7, 2).floor(), -4);
    EXPECT_EQ(WideRational(-7, 2).ceil(), -3);
    EXPECT_EQ(WideRational(6, 2).ceil(), 3);
}

}  // namespace
}  // namespace carom::pipeline
