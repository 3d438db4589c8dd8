#include "pipeline/picture/dashes.h"

#include <gtest/gtest.h>

namespace carom::pipeline {
namespace {

const StrongLine kLine{{{0, 0, 0}, 1}, {{0.1, 0, 0}, 1}, {{0.1, 0.1, 0}, 0}};  // 0.2 m long

double length_of(const StrongLine& line) {
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        length += (line[i].at - line[i - 1].at).length();
    }
    return length;
}

TEST(Dashes, OfASolidLine_AreTheLine) {
    const auto pieces = cut_into_dashes(kLine, Dash::solid, 1);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_EQ(pieces[0].size(), 3U);
}

TEST(Dashes, OfADashedLine_HaveTheirLengthAroundCorners) {
    const auto pieces = cut_into_dashes(kLine, Dash::dashed, 1);
    ASSERT_EQ(pieces.size(), 3U);  // at 0, 85 and 170 mm
    EXPECT_NEAR(length_of(pieces[0]), 0.05, 1e-12);
    EXPECT_NEAR(length_of(pieces[1]), 0.05, 1e-12);
    EXPECT_EQ(pieces[1].size(), 3U) << "the corner at 100 mm";
    EXPECT_NEAR(length_of(pieces[2]), 0.03, 1e-12) << "cut at the end";
    EXPECT_NEAR(pieces[2].front().strength, 0.3, 1e-12);
}

TEST(Dashes, OfADottedLine_ArePoints) {
    const auto pieces = cut_into_dashes(kLine, Dash::dotted, 2);
    ASSERT_EQ(pieces.size(), 4U);  // every 60 mm
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(pieces[i].size(), 1U);
    }
    EXPECT_NEAR(pieces[1].front().at.x, 0.06, 1e-12);
}

TEST(Dashes, OfALine_DoNotChangeWhereItGrows) {
    StrongLine longer = kLine;
    longer.push_back({{0.1, 0.3, 0}, 1});
    const auto before = cut_into_dashes(kLine, Dash::dash_dot, 1);
    const auto after = cut_into_dashes(longer, Dash::dash_dot, 1);
    ASSERT_GT(after.size(), before.size());
    for (std::size_t i = 0; i + 1 < before.size(); ++i) {
        ASSERT_EQ(before[i].size(), after[i].size());
        for (std::size_t k = 0; k < before[i].size(); ++k) {
            EXPECT_EQ(before[i][k].at, after[i][k].at);
        }
    }
}

}  // namespace
}  // namespace carom::pipeline
