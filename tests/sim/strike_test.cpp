// Alciatore, TP A-30 (speed and spin), TP A-31 (squirt) and TP B-8 (restitution of the tip).
#include "sim/stick/strike.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace carom::sim {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kMass = 0.170097;

StrikeResult struck(const Strike& strike) {
    return *strike_ball(strike, Vec3(0, 1, 0), RigidBody::ball(kMass, kRadius));
}

/// A tip that loses no energy, as in TP A-30, on a shaft with 1/30 of the ball's mass at its end.
Strike at_tip(double a, double b, double elevation = 0) {
    Strike strike;
    strike.speed = 2;
    strike.tip_restitution = 1;
    strike.end_mass_ratio = 1.0 / 30;
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
    // A ball that rolls along +y turns about -x; a tip at 0.4 R makes it roll immediately.
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

template <typename Visit>
void sweep(Visit visit) {
    for (const double a : {-0.45, -0.2, 0.0, 0.1, 0.5}) {
        for (const double up : {-0.45, -0.1, 0.0, 0.3, 0.45}) {
            for (const double theta : {0.0, 0.05, 0.4, 0.8, 1.3}) {
                for (const double speed : {0.5, 9.0}) {
                    for (const double stick : {0.3, 0.567}) {
                        visit(a, up, theta, speed, stick);
                    }
                }
            }
        }
    }
}

// TP A-30 in its own variables: b is the height above the centre, c the depth, in the horizontal
// frame.
TEST(Strike_Sweep, AgreesWithTheLevelFrameFormula) {
    sweep([](double right, double raised, double theta, double speed, double stick) {
        Strike strike = at_tip(right, raised, theta);
        strike.speed = speed;
        strike.stick_mass = stick;
        const double a = right * kRadius;
        const double up = raised * kRadius;
        const double deep = std::sqrt(kRadius * kRadius - a * a - up * up);
        const double ct = std::cos(theta);
        const double st = std::sin(theta);
        const double b = up * ct + deep * st;
        const double c = deep * ct - up * st;
        const StrikeResult result = struck(strike);
        const double expected =
            2 * speed /
            (1 + kMass / stick +
             2.5 / (kRadius * kRadius) *
                 (a * a + b * b * ct * ct + c * c * st * st - 2 * b * c * ct * st));
        EXPECT_NEAR(result.velocity.length() / expected, 1, 1e-13);
        const double rate = 2.5 * expected / (kRadius * kRadius);
        const Vec3 spin(-rate * (b * ct - c * st), rate * a * st, rate * a * ct);
        EXPECT_NEAR((result.angular_velocity - spin).length() * kRadius / expected, 0, 1e-13);
    });
}

// TP A-31: counter-clockwise atan2(2.5 a sqrt(1 - a^2), 1 + m/m_end + 2.5 (1 - a^2)), for any other
// parameters of the strike.
TEST(Strike_Sweep, SquirtsByTheFormula) {
    for (const double end_mass : {1.0 / 60, 1.0 / 30, 0.1}) {
        sweep([=](double a, double up, double theta, double speed, double) {
            Strike strike = at_tip(a, up, theta);
            strike.speed = speed;
            strike.end_mass_ratio = end_mass;
            const Vec3 v = struck(strike).velocity;
            const double squirt =
                std::atan2(2.5 * a * std::sqrt(1 - a * a), 1 + 1 / end_mass + 2.5 * (1 - a * a));
            EXPECT_NEAR(std::atan2(-v.x, v.y), squirt, 1e-14);
        });
    }
}

// The energy of the stick before equals that of ball and stick afterwards.
TEST(Strike_Sweep, ConservesTheEnergyOfStickAndBall) {
    sweep([](double a, double up, double theta, double speed, double stick) {
        Strike strike = at_tip(a, up, theta);
        strike.speed = speed;
        strike.stick_mass = stick;
        const StrikeResult result = struck(strike);
        const Vec3& w = result.angular_velocity;
        const double v = result.velocity.length();
        const double ball = 0.5 * kMass * (v * v + 0.4 * kRadius * kRadius * w.dot(w));
        const double after = speed - kMass * v / stick;
        EXPECT_NEAR(ball + 0.5 * stick * after * after, 0.5 * stick * speed * speed,
                    1e-12 * stick * speed * speed);
    });
}

// A tip of restitution e returns e^2 of the energy of its compression, which ends when tip and
// struck point are equally fast: 1/2 V^2 / (1/M + (1 + 5/2 b^2)/m).
TEST(Strike_Sweep, LosesTheRestOfTheEnergyOfCompression) {
    for (const double e : {0.0, 0.3, 0.73, 0.84}) {
        sweep([=](double a, double up, double theta, double speed, double stick) {
            Strike strike = at_tip(a, up, theta);
            strike.speed = speed;
            strike.stick_mass = stick;
            strike.tip_restitution = e;
            const StrikeResult result = struck(strike);
            const Vec3& w = result.angular_velocity;
            const double v = result.velocity.length();
            const double ball = 0.5 * kMass * (v * v + 0.4 * kRadius * kRadius * w.dot(w));
            const double after = speed - kMass * v / stick;
            const double lost = 0.5 * stick * (speed * speed - after * after) - ball;
            const double compression =
                0.5 * speed * speed / (1 / stick + (1 + 2.5 * (a * a + up * up)) / kMass);
            EXPECT_NEAR(lost, (1 - e * e) * compression, 1e-12 * stick * speed * speed);
        });
    }
}

// Alciatore's FAQ: with leather tips the ball is 1.27 to 1.35 times as fast as the stick. Pool
// balls weigh 5.5 to 6 oz (156 to 170 g), usual sticks 18 to 21 oz (510 to 595 g).
TEST(Strike_CentreHitWithALeatherTip, GivesTheMeasuredRatio) {
    for (const double ounces : {18.0, 19.0, 20.0, 21.0}) {
        Strike strike;
        strike.speed = 1;
        strike.stick_mass = ounces * 0.028349523;
        const double ratio = struck(strike).velocity.length();
        EXPECT_GT(ratio, 1.27) << ounces;
        EXPECT_LT(ratio, 1.35) << ounces;
    }
}

// A regular shaft deflects the ball by about 2.5 degrees at half a radius (Alciatore, quoted).
TEST(Strike_WithTheDefaultShaft, SquirtsAsARegularOne) {
    Strike strike;
    strike.speed = 1;
    strike.tip = {0.5, 0};
    const Vec3 v = struck(strike).velocity;
    EXPECT_NEAR(std::atan2(-v.x, v.y) * 180 / std::numbers::pi, 2.5, 0.05);
}

TEST(Strike_ByBallSpeed, GivesThatSpeed) {
    Strike strike;
    strike.ball_speed = 3;
    strike.tip = {0.3, 0.1};
    strike.elevation = 0.2;
    EXPECT_NEAR(struck(strike).velocity.length(), 3, 1e-13);
}

RigidBody moving(const Vec3& velocity, const Vec3& spin = {0, 0, 0}) {
    RigidBody ball = RigidBody::ball(kMass, kRadius);
    ball.state.velocity = velocity;
    ball.state.angular_velocity = spin;
    return ball;
}

// The stick pushes off what it meets: its speed counts relative to the struck point.
TEST(Strike_OnAMovingBall, ChangesItsVelocityByTheRelativeSpeed) {
    const Strike strike = at_tip(0.3, 0.2, 0.4);
    const StrikeResult rest = struck(strike);
    const TipContact tip = tip_contact(strike, Vec3(0, 1, 0), kRadius);
    for (const RigidBody& ball :
         {moving({0, 1, 0}), moving({0.5, -3, 0}), moving({1, -1, 0}, {20, -30, 40})}) {
        const StrikeResult result = *strike_ball(strike, Vec3(0, 1, 0), ball);
        const double v = Vec3(0, std::cos(0.4), -std::sin(0.4)).dot(ball.state.velocity) +
                         tip.lever.dot(ball.state.angular_velocity);
        const double part = (2 - v) / 2;
        EXPECT_NEAR((result.velocity - rest.velocity * part).length(), 0, 1e-13);
        EXPECT_NEAR((result.angular_velocity - rest.angular_velocity * part).length(), 0, 1e-10);
    }
}

TEST(Strike_ByATipWithoutLosses, KeepsTheEnergyOfBallAndStick) {
    Strike strike = at_tip(0, 0.3);
    strike.end_mass_ratio = 1e-9;
    const RigidBody ball = moving({0.4, -1.5, 0}, {30, 10, -20});
    const StrikeResult result = *strike_ball(strike, Vec3(0, 1, 0), ball);
    const auto energy = [](const Vec3& v, const Vec3& w) {
        return 0.5 * kMass * (v.dot(v) + 0.4 * kRadius * kRadius * w.dot(w));
    };
    const double stick = 2 - kMass * result.velocity.y / strike.stick_mass;
    EXPECT_NEAR(
        energy(ball.state.velocity + result.velocity,
               ball.state.angular_velocity + result.angular_velocity) +
            0.5 * strike.stick_mass * stick * stick,
        energy(ball.state.velocity, ball.state.angular_velocity) + 0.5 * strike.stick_mass * 4,
        1e-12);
}

TEST(Strike_OnABallThatOutrunsIt, DoesNotHappen) {
    const Strike strike = at_tip(0, 0);
    EXPECT_FALSE(strike_ball(strike, Vec3(0, 1, 0), moving({0, 2, 0})));
    EXPECT_FALSE(strike_ball(strike, Vec3(0, 1, 0), moving({0, 3, 0})));
    EXPECT_TRUE(strike_ball(strike, Vec3(0, 1, 0), moving({5, 1.9, 0})));
    Strike by_ball = strike;
    by_ball.speed.reset();
    by_ball.ball_speed = 3;
    EXPECT_FALSE(strike_ball(by_ball, Vec3(0, 1, 0), moving({0, 3, 0})));
    EXPECT_FALSE(strike_ball(by_ball, Vec3(0, 1, 0), moving({4, 0, 0})));
}

TEST(Strike_ByBallSpeed, GivesThatSpeedToAMovingBall) {
    Strike strike;
    strike.ball_speed = 3;
    strike.tip = {0.3, 0.1};
    for (const Vec3& velocity : {Vec3(0, -2, 0), Vec3(1, 1, 0), Vec3(-2, 0.5, 0)}) {
        const StrikeResult result = *strike_ball(strike, Vec3(0, 1, 0), moving(velocity));
        EXPECT_NEAR((velocity + result.velocity).length(), 3, 1e-13);
        EXPECT_GT(result.velocity.y, 0);
    }
}

}  // namespace
}  // namespace carom::sim
