// Aims as plane geometry, against closed forms.
#include "sim/aim/ghost_ball.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace carom::sim {
namespace {

using ::testing::ElementsAre;

constexpr double kPi = std::numbers::pi;
constexpr double kRadius = 0.028575;

std::vector<PocketMouth> pool_mouths() {
    return pocket_mouths(*billiards::standard_table(billiards::TableKind::pool, "9 ft"), kRadius);
}

/// The distance of a point from a line in that direction, positive to the left of it.
double left_of(const Vec2& from, double direction, const Vec2& point) {
    const Vec2 along(std::cos(direction), std::sin(direction));
    return along.x * (point - from).y - along.y * (point - from).x;
}

TEST(Angles, AreWrappedIntoOneTurn) {
    EXPECT_DOUBLE_EQ(wrapped(kPi), kPi);
    EXPECT_DOUBLE_EQ(wrapped(-kPi), kPi);
    EXPECT_DOUBLE_EQ(wrapped(0.25), 0.25);
    EXPECT_NEAR(wrapped(0.25 + 6 * kPi), 0.25, 1e-14);
    EXPECT_NEAR(wrapped(-0.25 - 8 * kPi), -0.25, 1e-14);
}

TEST(PassingDirection, IsTheArcsineOfTheOffset) {
    const Vec2 from(-0.5, 0.2), to(0.3, -0.4);  // 1 m
    EXPECT_NEAR(*passing_direction(from, to, 0), std::atan2(-0.6, 0.8), 1e-15);
    for (const double offset : {-0.5, -kRadius, 0.01, 2 * kRadius}) {
        const double direction = *passing_direction(from, to, offset);
        EXPECT_NEAR(left_of(from, direction, to), -offset, 1e-15);
    }
    EXPECT_FALSE(passing_direction(from, to, 1.0 + 1e-12).has_value());
}

TEST(TouchingDistance, IsThatOfBallsOnTheCloth) {
    EXPECT_NEAR(touching_distance(kRadius, kRadius), 2 * kRadius, 1e-17);
    // Centres at heights a and b, (a + b) apart: level distance^2 = (a + b)^2 - (a - b)^2 = 4 a b.
    EXPECT_NEAR(touching_distance(0.03, 0.02), std::sqrt(0.05 * 0.05 - 0.01 * 0.01), 1e-16);
}

TEST(PocketMouths, AreSymmetricAboutTheirAxes) {
    const std::vector<PocketMouth> mouths = pool_mouths();
    ASSERT_EQ(mouths.size(), 6u);
    std::vector<std::string> names;
    for (const PocketMouth& mouth : mouths) {
        SCOPED_TRACE(mouth.name);
        names.push_back(mouth.name);
        const Vec2 side(-mouth.axis.y, mouth.axis.x);
        const Vec2 left = mouth.ends[0] - mouth.middle;
        const Vec2 right = mouth.ends[1] - mouth.middle;
        EXPECT_GT(left.dot(side), 0.05);
        EXPECT_NEAR(left.dot(side), -right.dot(side), 1e-12);
        EXPECT_NEAR(left.dot(mouth.axis), right.dot(mouth.axis), 1e-12);
        EXPECT_NEAR(mouth.nearest[0], mouth.nearest[1], 1e-15);
        // The nose's rounding of 3 mm, and the ball at the height of the nose.
        const double above = 0.635 * 2 * kRadius - kRadius;
        EXPECT_NEAR(mouth.nearest[0], 0.003 + std::sqrt(kRadius * kRadius - above * above), 1e-9);
    }
    EXPECT_THAT(names, ElementsAre("corner_left_front", "side_front", "corner_right_front",
                                   "corner_right_back", "side_back", "corner_left_back"));
}

TEST(PocketWindow, FromTheAxisIsSymmetric) {
    for (const PocketMouth& mouth : pool_mouths()) {
        SCOPED_TRACE(mouth.name);
        const double distance = 0.5;
        const Vec2 from = mouth.middle - mouth.axis * distance;
        const Vec2 end = mouth.ends[0] - from;
        const double along = end.dot(mouth.axis);
        const double across = end.dot(Vec2(-mouth.axis.y, mouth.axis.x));
        const double half =
            std::atan2(across, along) - std::asin(mouth.nearest[0] / std::hypot(across, along));
        const PocketWindow window = window_of(mouth, from);
        EXPECT_NEAR(window.middle, std::atan2(mouth.axis.y, mouth.axis.x), 1e-12);
        EXPECT_NEAR(window.width, 2 * half, 1e-12);
    }
}

TEST(PocketWindow, EndsWhereTheBallTouchesTheNoses) {
    for (const PocketMouth& mouth : pool_mouths()) {
        for (const Vec2& from : {Vec2(0.1, 0.05), Vec2(-0.6, 0.3), Vec2(0.9, -0.5)}) {
            const PocketWindow window = window_of(mouth, from);
            const double left = window.middle + 0.5 * window.width;
            const double right = window.middle - 0.5 * window.width;
            EXPECT_NEAR(left_of(from, left, mouth.ends[0]), mouth.nearest[0], 1e-12);
            EXPECT_NEAR(left_of(from, right, mouth.ends[1]), -mouth.nearest[1], 1e-12);
        }
    }
}

TEST(PocketWindow, OfASidePocketClosesAlongTheRail) {
    const PocketMouth side = pool_mouths()[1];  // at (0, -0.635)
    EXPECT_GT(window_of(side, {0.3, 0}).width, 0.05);
    EXPECT_LT(window_of(side, {1.0, -0.5}).width, 0);
}

TEST(FirstInWay, IsTheNearestThatIsTouched) {
    const std::vector<billiards::LyingBall> balls{{"far", {0.8, 0.05}, kRadius},
                                                  {"near", {0.4, -0.05}, kRadius},
                                                  {"aside", {0.2, 0.0572}, kRadius},
                                                  {"behind", {-0.02, 0}, kRadius},
                                                  {"beyond", {1.1, 0}, kRadius}};
    const Vec2 from(0, 0), to(1, 0);
    EXPECT_EQ(first_in_way(balls, from, to, kRadius, {})->name, "near");
    EXPECT_EQ(first_in_way(balls, from, to, kRadius, {"near"})->name, "far");
    EXPECT_EQ(first_in_way(balls, from, to, kRadius, {"near", "far"}), nullptr);
    EXPECT_EQ(first_in_way(balls, from, from, kRadius, {}), nullptr);
}

}  // namespace
}  // namespace carom::sim
