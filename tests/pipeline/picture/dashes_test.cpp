#include "pipeline/picture/dashes.h"

#include <gtest/gtest.h>

#include "pipeline/picture/line_dashes.h"
#include "tests/pipeline/picture/drawn_scene.h"

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

/// 1 m long, across the view at that distance.
SceneLine line_at(double distance, Dash dash) {
    SceneLine line;
    line.points = {{-0.5, distance - 1, 0}, {0.5, distance - 1, 0}};
    line.dash = dash;
    return line;
}

std::vector<LineDash> seen_dashes(const SceneLine& line) {
    return dashes_of(line, Pinhole(carom::testing::frame_at(0), 160, 120));
}

TEST(LineDashes, FarAway_AreLonger) {
    const double near = length_of(seen_dashes(line_at(1, Dash::dashed)).front().points);
    const double far = length_of(seen_dashes(line_at(8, Dash::dashed)).front().points);
    EXPECT_GE(far, 4 * near);
}

TEST(LineDashes, OfADottedLine_AreThickRoundDots) {
    for (const LineDash& dash : seen_dashes(line_at(1, Dash::dotted))) {
        EXPECT_EQ(dash.points.size(), 1U);
        EXPECT_EQ(dash.thickness, 1.5);
        EXPECT_TRUE(dash.has_round_ends);
    }
}

TEST(LineDashes, Head_IsAtTheEndOfTheLine) {
    SceneLine line = line_at(1, Dash::dash_dot);
    line.has_head = true;
    for (const LineDash& dash : seen_dashes(line)) {
        EXPECT_EQ(dash.has_head, dash.points.back().at == line.points.back());
    }
    line.dash = Dash::solid;
    ASSERT_EQ(seen_dashes(line).size(), 1U);
    EXPECT_TRUE(seen_dashes(line).front().has_head);
}

TEST(LineDashes, OfAClosedLine_ReachItsStart) {
    SceneLine line = line_at(1, Dash::solid);
    line.points.emplace_back(0, 0, 0.5);
    line.is_closed = true;
    ASSERT_EQ(seen_dashes(line).size(), 1U);
    EXPECT_TRUE(seen_dashes(line).front().is_closed);
    line.dash = Dash::dashed;
    double most = 0;
    for (const LineDash& dash : seen_dashes(line)) {
        EXPECT_FALSE(dash.is_closed);
        const Vec3 middle = 0.5 * (line.points.back() + line.points.front());
        most = std::max(most, (dash.points.front().at - middle).length() < 0.3 ? 1.0 : 0.0);
    }
    EXPECT_EQ(most, 1) << "a dash on the side that closes it";
}

TEST(LineDashes, OfAPoint_AreNone) {
    SceneLine line = line_at(1, Dash::solid);
    line.points.resize(1);
    EXPECT_TRUE(seen_dashes(line).empty());
}

}  // namespace
}  // namespace carom::pipeline
