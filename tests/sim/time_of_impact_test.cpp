#include "sim/motion/time_of_impact.h"

#include <cmath>

#include <gtest/gtest.h>

namespace carom::sim {
namespace {

MotionSegment moving(const Vec3& position, const Vec3& velocity,
                     const Vec3& acceleration = {0, 0, 0}) {
    MotionSegment segment;
    segment.state.position = position;
    segment.state.velocity = velocity;
    segment.acceleration = acceleration;
    return segment;
}

TEST(BallImpactTime_HeadOn, IsWhenTheGapCloses) {
    const auto t =
        ball_impact_time(moving({0, 0, 0}, {2, 0, 0}), moving({1, 0, 0}, {-1, 0, 0}), 0.1, 0, 5);
    EXPECT_NEAR(t.value(), 0.3, 1e-15);
}

TEST(BallImpactTime_AcceleratedAndOblique, EndsAtTheGivenDistance) {
    const MotionSegment a = moving({0, 0, 0}, {3, 0.4, 0}, {-1.9, 0.3, 0});
    const MotionSegment b = moving({1, 0.1, 0}, {-0.5, 0.2, 0}, {0.05, -0.02, 0});
    const auto t = ball_impact_time(a, b, 0.06, 0, 2);
    ASSERT_TRUE(t);
    EXPECT_NEAR((a.position_at(*t) - b.position_at(*t)).length(), 0.06, 5e-15);
}

TEST(BallImpactTime_TooShortAWindow, IsEmpty) {
    EXPECT_FALSE(
        ball_impact_time(moving({0, 0, 0}, {2, 0, 0}), moving({1, 0, 0}, {0, 0, 0}), 0.1, 0, 0.4));
}

TEST(BallImpactTime_TouchingAndSeparating, IsNoImpact) {
    EXPECT_FALSE(
        ball_impact_time(moving({0, 0, 0}, {-1, 0, 0}), moving({0.1, 0, 0}, {0, 0, 0}), 0.1, 0, 5));
}

TEST(BallImpactTime_TouchingAndApproaching, IsNow) {
    MotionSegment a = moving({0, 0, 0}, {1, 0, 0});
    a.start = 0.25;
    EXPECT_EQ(ball_impact_time(a, moving({0.1, 0, 0}, {0, 0, 0}), 0.1, 0.25, 5).value(), 0.25);
}

TEST(BallImpactTime_SeparatingButAcceleratedBack, IsTheLaterImpact) {
    // Leaves at 1 m/s, accelerated back at 2 m/s^2: touches again after 1 s.
    const auto t = ball_impact_time(moving({0, 0, 0}, {-1, 0, 0}, {2, 0, 0}),
                                    moving({0.1, 0, 0}, {0, 0, 0}), 0.1, 0, 5);
    EXPECT_NEAR(t.value(), 1, 1e-14);
}

TEST(BallImpactTime_GrazingPass, IsFoundByATinyMargin) {
    const MotionSegment still = moving({1, 0, 0}, {0, 0, 0});
    EXPECT_TRUE(ball_impact_time(moving({0, 0.1 - 1e-9, 0}, {1, 0, 0}), still, 0.1, 0, 5));
    EXPECT_FALSE(ball_impact_time(moving({0, 0.1 + 1e-9, 0}, {1, 0, 0}), still, 0.1, 0, 5));
}

TEST(PlaneImpactTime_FreeFall, IsTheTimeOfTheParabola) {
    const auto t = plane_impact_time(moving({0, 0, 1}, {0, 0, 0}, {0, 0, -9.81}), {0, 0, 0},
                                     {0, 0, 1}, 0.1, 0, 5);
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
