#include "core/text.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace carom {
namespace {

using Words = std::vector<std::string>;

TEST(Join, Words_AreSeparated) {
    EXPECT_EQ(join(Words{}, ", "), "");
    EXPECT_EQ(join(Words{"a"}, ", "), "a");
    EXPECT_EQ(join(Words{"a", "", "{c}"}, ", "), "a, , {c}");
}

TEST(Enumerate, Conjunction_StandsBetweenTheLastTwo) {
    EXPECT_EQ(enumerate(Words{}, "or"), "");
    EXPECT_EQ(enumerate(Words{"a"}, "or"), "a");
    EXPECT_EQ(enumerate(Words{"a", "b"}, "or"), "a or b");
    EXPECT_EQ(enumerate(Words{"a", "b", "c"}, "or"), "a, b or c");
}

TEST(Counted, OneThing_IsSingular) {
    EXPECT_EQ(counted(0, "file"), "0 files");
    EXPECT_EQ(counted(1, "file"), "1 file");
    EXPECT_EQ(counted(2, "damaged file"), "2 damaged files");
}

TEST(DecimalText, TrailingZeros_AreOmitted) {
    EXPECT_EQ(decimal_text(1.25, 6), "1.25");
    EXPECT_EQ(decimal_text(3, 6), "3");
    EXPECT_EQ(decimal_text(100, 0), "100");
    EXPECT_EQ(decimal_text(-0.5, 1), "-0.5");
    EXPECT_EQ(decimal_text(0.0625, 3), "0.062");  // a tie goes to the even digit
}

TEST(DecimalText, NumberThatRoundsToZero_HasNoSign) {
    EXPECT_EQ(decimal_text(-0.0, 3), "0");
    EXPECT_EQ(decimal_text(-0.0004, 3), "0");
    EXPECT_EQ(decimal_text(-0.4, 0), "0");
}

TEST(DecimalText, LargestNumber_IsPrintedInFull) {
    const std::string text = decimal_text(std::numeric_limits<double>::max(), 2);
    EXPECT_EQ(text.size(), 309U);
    EXPECT_EQ(text.substr(0, 17), "17976931348623157");
}

TEST(SecondsText, Times_AreRoundedToTheMicrosecond) {
    EXPECT_EQ(seconds_text(1.0 / 3), "0.333333 s");
    EXPECT_EQ(seconds_text(-2.5), "-2.5 s");
    EXPECT_EQ(seconds_text(10), "10 s");
}

TEST(EditDistance, OneOfEachEdit_CountsOne) {
    EXPECT_EQ(edit_distance("cushion", "cushion"), 0U);
    EXPECT_EQ(edit_distance("cushion", "cushon"), 1U);
    EXPECT_EQ(edit_distance("cushion", "cusshion"), 1U);
    EXPECT_EQ(edit_distance("cushion", "cuchion"), 1U);
    EXPECT_EQ(edit_distance("cushion", "cuhsion"), 1U);
}

TEST(EditDistance, KnownDistances_AreFound) {
    EXPECT_EQ(edit_distance("", "abc"), 3U);
    EXPECT_EQ(edit_distance("abc", ""), 3U);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
    EXPECT_EQ(edit_distance("ca", "abc"), 3U);  // an exchanged pair is not edited again
}

}  // namespace
}  // namespace carom
