#include "sim/motion/time_of_impact.h"

#include <cmath>

#include <gtest/gtest.h>

namespace carom::sim {
namespace {

Stretch moving(const Vec3& position, const Vec3& velocity, const Vec3& acceleration = {0, 0, 0}) {
    Stretch stretch;
    stretch.state.position = position;
    stretch.state.velocity = velocity;
    stretch.acceleration = acceleration;
    return stretch;
}

TEST(BallTouch_HeadOn, IsWhenTheGapIsUsedUp) {
    const auto t =
        ball_touch(moving({0, 0, 0}, {2, 0, 0}), moving({1, 0, 0}, {-1, 0, 0}), 0.1, 0, 5);
    EXPECT_NEAR(t.value(), 0.3, 1e-15);
}

TEST(BallTouch_AcceleratedAndOblique, EndsAtTheGivenDistance) {
    const Stretch a = moving({0, 0, 0}, {3, 0.4, 0}, {-1.9, 0.3, 0});
    const Stretch b = moving({1, 0.1, 0}, {-0.5, 0.2, 0}, {0.05, -0.02, 0});
    const auto t = ball_touch(a, b, 0.06, 0, 2);
    ASSERT_TRUE(t);
    EXPECT_NEAR((a.position_at(*t) - b.position_at(*t)).length(), 0.06, 5e-15);
}

TEST(BallTouch_TooShortAWindow, IsEmpty) {
    EXPECT_FALSE(
        ball_touch(moving({0, 0, 0}, {2, 0, 0}), moving({1, 0, 0}, {0, 0, 0}), 0.1, 0, 0.4));
}

TEST(BallTouch_TouchingAndSeparating, IsNotATouch) {
    EXPECT_FALSE(
        ball_touch(moving({0, 0, 0}, {-1, 0, 0}), moving({0.1, 0, 0}, {0, 0, 0}), 0.1, 0, 5));
}

TEST(BallTouch_TouchingAndApproaching, IsNow) {
    Stretch a = moving({0, 0, 0}, {1, 0, 0});
    a.start = 0.25;
    EXPECT_EQ(ball_touch(a, moving({0.1, 0, 0}, {0, 0, 0}), 0.1, 0.25, 5).value(), 0.25);
}

TEST(BallTouch_SeparatingButDrawnBack, ComesBackLater) {
    // Leaves at 1 m/s, accelerated back at 2 m/s^2: touches again after 1 s.
    const auto t = ball_touch(moving({0, 0, 0}, {-1, 0, 0}, {2, 0, 0}),
                              moving({0.1, 0, 0}, {0, 0, 0}), 0.1, 0, 5);
    EXPECT_NEAR(t.value(), 1, 1e-14);
}

TEST(BallTouch_GrazingPass, IsFoundOrNotByAHair) {
    const Stretch still = moving({1, 0, 0}, {0, 0, 0});
    EXPECT_TRUE(ball_touch(moving({0, 0.1 - 1e-9, 0}, {1, 0, 0}), still, 0.1, 0, 5));
    EXPECT_FALSE(ball_touch(moving({0, 0.1 + 1e-9, 0}, {1, 0, 0}), still, 0.1, 0, 5));
}

TEST(PlaneTouch_FreeFall, IsAfterTheTimeOfTheParabola) {
    const auto t =
        plane_touch(moving({0, 0, 1}, {0, 0, 0}, {0, 0, -9.81}), {0, 0, 0}, {0, 0, 1}, 0.1, 0, 5);
    EXPECT_NEAR(t.value(), std::sqrt(2 * 0.9 / 9.81), 1e-15);
}

TEST(LineDeparture_InsideATube, IsAtTheWall) {
    const auto t = line_departure(moving({0, 0, 0}, {1, 0, -3}), {0, 0, 5}, {0, 0, 1}, 0.25, 0, 5);
    EXPECT_NEAR(t.value(), 0.25, 1e-15);
}

TEST(LineDeparture_EnteringFromOutside, IsAtTheFarWall) {
    const auto t =
        line_departure(moving({-0.5, 0, 0}, {1, 0, 0}), {0, 0, 0}, {0, 0, 1}, 0.25, 0, 5);
    EXPECT_NEAR(t.value(), 0.75, 1e-15);
}

}  // namespace
}  // namespace carom::sim
