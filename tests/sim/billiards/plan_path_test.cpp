#include "sim/billiards/plan_path.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace carom::sim::billiards {
namespace {

constexpr double kPi = std::numbers::pi;

void expect_near(const Vec2& a, const Vec2& b, double bound = 1e-12) {
    EXPECT_NEAR((a - b).length(), 0, bound) << a << " and " << b;
}

TEST(PlanPath, StraightLine_IsDividedEvenly) {
    const PlanPath path = PathBuilder(OpenSide::left, 0.3).start({0, 0}).line_to({1, 0}).finish();
    ASSERT_EQ(path.size(), 5U);
    expect_near(path[1].position, {0.25, 0});
    EXPECT_NEAR(path.back().length, 1, 1e-15);
    for (const PathPoint& point : path) {
        expect_near(point.normal_out, {0, 1});
    }
    expect_near(path[2].inside(0.1), {0.5, -0.1});
}

TEST(PlanPath, SharpCorner_IsMitred) {
    const PlanPath path =
        PathBuilder(OpenSide::left, 10).start({0, 0}).line_to({1, 0}).line_to({1, -1}).finish();
    expect_near(path[1].normal_in, {0, 1});
    expect_near(path[1].normal_out, {1, 0});
    expect_near(path[1].inside(0.2), {0.8, -0.2});
}

TEST(PlanPath, Rounding_IsAnArcThatTouchesBothLines) {
    const PlanPath path = PathBuilder(OpenSide::left, 10)
                              .start({0, 0})
                              .round({1, 0}, 0.2, {1, -1})
                              .line_to({1, -1})
                              .finish();
    expect_near(path[1].position, {0.8, 0});
    expect_near(path[path.size() - 2].position, {1, -0.2});
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
        EXPECT_NEAR((path[i].position - Vec2(0.8, -0.2)).length(), 0.2, 1e-12);
        expect_near(path[i].normal_out, (path[i].position - Vec2(0.8, -0.2)) / 0.2);
    }
}

// At an offset larger than its radius the rounding is the sharp corner of the offset lines.
TEST(PlanPath, RoundingOffsetBeyondItsRadius_ShrinksToACorner) {
    const PlanPath path = PathBuilder(OpenSide::left, 10)
                              .start({0, 0})
                              .round({1, 0}, 0.2, {1, -1})
                              .line_to({1, -1})
                              .finish();
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
        expect_near(path[i].inside(0.2), {0.8, -0.2});
        expect_near(path[i].inside(0.5), {0.5, -0.5});
    }
}

TEST(PlanPath, ConcaveRounding_GrowsInsteadOfShrinking) {
    const PlanPath path = PathBuilder(OpenSide::left, 10)
                              .start({0, 0})
                              .round({1, 0}, 0.2, {1, 1})
                              .line_to({1, 1})
                              .finish();
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
        EXPECT_NEAR((path[i].inside(0.5) - Vec2(0.8, 0.2)).length(), 0.7, 1e-12);
    }
}

TEST(PlanPath, Arc_RunsInTheGivenDirection) {
    const PlanPath far =
        PathBuilder(OpenSide::left, 10).start({1, 0}).arc_to({0, -1}, {0, 0}, true).finish();
    EXPECT_NEAR(far.back().length, 1.5 * kPi, 2e-3);
    expect_near(far[1].normal_out, -far[1].position);
    const PlanPath near =
        PathBuilder(OpenSide::left, 10).start({1, 0}).arc_to({0, -1}, {0, 0}, false).finish();
    EXPECT_NEAR(near.back().length, 0.5 * kPi, 1e-3);
    expect_near(near[1].normal_out, near[1].position);
}

TEST(PlanPath, SlantedCut_ContainsOffsetEnds) {
    const PlanPath path =
        PathBuilder(OpenSide::left, 10).start({0, 0}).line_to({1, 0}).finish({1, -1}, {-1, -1});
    expect_near(path.front().inside(0.3), {0.3, -0.3});
    expect_near(path.back().inside(0.3), {0.7, -0.3});
}

TEST(PlanPath, ClosedOutline_EndsAtItsStart) {
    const PlanPath path = PathBuilder(OpenSide::right, 0.25)
                              .start({0, 0})
                              .line_to({1, 0})
                              .line_to({1, 1})
                              .line_to({0, 1})
                              .finish_closed();
    expect_near(path.front().position, path.back().position);
    expect_near(path.front().inside(0.1), {0.1, 0.1});
    expect_near(path.back().inside(0.1), {0.1, 0.1});
    EXPECT_NEAR(path.back().length, 4, 1e-14);
}

}  // namespace
}  // namespace carom::sim::billiards
