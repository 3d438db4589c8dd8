// Alciatore, TP A-30 (speed and spin) and TP A-31 (squirt).
#include "sim/stick/strike.h"

#include <cmath>

#include <gtest/gtest.h>

namespace carom::sim {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kMass = 0.170097;

StrikeResult struck(const Strike& strike) {
    return strike_ball(strike, Vec3(0, 1, 0), kMass, kRadius);
}

Strike at_tip(double a, double b, double elevation = 0) {
    Strike strike;
    strike.speed = 2;
    strike.tip = {a, b};
    strike.elevation = elevation;
    return strike;
}

TEST(Strike_CentreHit, GivesTheSpeedOfAHeadOnImpact) {
    const StrikeResult result = struck(at_tip(0, 0));
    EXPECT_NEAR(result.velocity.y, 2 * 2 / (1 + kMass / 0.567), 1e-13);
    EXPECT_EQ(result.angular_velocity, Vec3(0, 0, 0));
}

TEST(Strike_AboveTheCentre, GivesFollow) {
    const StrikeResult result = struck(at_tip(0, 0.4));
    // A ball that rolls along +y turns about -x; 0.4 R makes it roll at once.
    EXPECT_NEAR(result.angular_velocity.x, -result.velocity.y / kRadius, 1e-10);
    EXPECT_NEAR(result.velocity.y, 4 / (1 + kMass / 0.567 + 2.5 * 0.16), 1e-13);
}

TEST(Strike_RightOfTheCentre, SpinsCounterClockwiseAndSquirtsLeft) {
    const StrikeResult result = struck(at_tip(0.5, 0));
    EXPECT_GT(result.angular_velocity.z, 0);
    EXPECT_LT(result.velocity.x, 0);
    const double expected = 2.5 * 0.5 * std::sqrt(0.75) / (1 + 30 + 2.5 * 0.75);
    EXPECT_NEAR(std::atan2(-result.velocity.x, result.velocity.y), std::atan(expected), 1e-14);
    EXPECT_NEAR(result.angular_velocity.z, 2.5 * 0.5 * result.velocity.length() / kRadius, 1e-9);
}

TEST(Strike_LeftOfTheCentre, IsTheMirrorImage) {
    const StrikeResult right = struck(at_tip(0.3, 0.2));
    const StrikeResult left = struck(at_tip(-0.3, 0.2));
    EXPECT_DOUBLE_EQ(left.velocity.x, -right.velocity.x);
    EXPECT_DOUBLE_EQ(left.velocity.y, right.velocity.y);
    EXPECT_DOUBLE_EQ(left.angular_velocity.z, -right.angular_velocity.z);
    EXPECT_DOUBLE_EQ(left.angular_velocity.x, right.angular_velocity.x);
}

TEST(Strike_Elevated, DrivesTheBallIntoTheSlate) {
    const double elevation = 0.5;
    const StrikeResult result = struck(at_tip(0, 0, elevation));
    EXPECT_NEAR(result.velocity.z / result.velocity.y, -std::tan(elevation), 1e-14);
    EXPECT_EQ(result.angular_velocity.length(), 0);
}

/// The proof's own variables: b is the height above the centre, c the depth, in the level frame.
TEST(Strike_ElevatedWithOffset, AgreesWithTheLevelFrameFormula) {
    const double theta = 0.7;
    const double a = 0.2 * kRadius;
    const double up = 0.3 * kRadius;
    const double deep = std::sqrt(kRadius * kRadius - a * a - up * up);
    const double b = up * std::cos(theta) + deep * std::sin(theta);
    const double c = deep * std::cos(theta) - up * std::sin(theta);
    const StrikeResult result = struck(at_tip(0.2, 0.3, theta));
    const double ct = std::cos(theta);
    const double st = std::sin(theta);
    const double speed = 2 * 2 /
                         (1 + kMass / 0.567 +
                          2.5 / (kRadius * kRadius) *
                              (a * a + b * b * ct * ct + c * c * st * st - 2 * b * c * ct * st));
    EXPECT_NEAR(result.velocity.length(), speed, 1e-12);
    const double rate = 2.5 * speed / (kRadius * kRadius);
    EXPECT_NEAR(result.angular_velocity.x, -rate * (b * ct - c * st), 1e-9);
    EXPECT_NEAR(result.angular_velocity.y, rate * a * st, 1e-9);
    EXPECT_NEAR(result.angular_velocity.z, rate * a * ct, 1e-9);
}

TEST(Strike_ByBallSpeed, GivesThatSpeed) {
    Strike strike;
    strike.ball_speed = 3;
    strike.tip = {0.3, 0.1};
    strike.elevation = 0.2;
    EXPECT_NEAR(struck(strike).velocity.length(), 3, 1e-13);
}

}  // namespace
}  // namespace carom::sim
