#include "core/splitmix.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

// The first outputs of java.util.SplittableRandom's mix64 and of the public domain program
// splitmix64.c (Vigna 2015) for the seed 1234567.
TEST(SplitMix64, FirstNumbers_AreThoseOfTheReference) {
    SplitMix64 random(1234567);
    EXPECT_EQ(random.next(), 6457827717110365317U);
    EXPECT_EQ(random.next(), 3203168211198807973U);
    EXPECT_EQ(random.next(), 9817491932198370423U);
    EXPECT_EQ(random.next(), 4593380528125082431U);
    EXPECT_EQ(random.next(), 16408922859458223821U);
}

TEST(SplitMix64, UnitNumbers_ReachFromZeroToJustBelowOne) {
    EXPECT_EQ(unit_number(0), 0);
    EXPECT_EQ(unit_number(~std::uint64_t{0}), 1 - 0x1p-53);
    EXPECT_EQ(unit_number(std::uint64_t{1} << 63U), 0.5);
}

}  // namespace
}  // namespace carom
