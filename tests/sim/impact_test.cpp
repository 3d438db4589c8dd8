// Compares impulses with their published formulas.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/impact/ball_impact.h"
#include "sim/impact/cushion_impact.h"
#include "sim/ode/process.h"

namespace carom::sim {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kMass = 0.170097;

RigidBody ball(const Vec3& position, const Vec3& velocity, const Vec3& spin = {0, 0, 0}) {
    RigidBody body = RigidBody::ball(kMass, kRadius);
    body.state.position = position;
    body.state.velocity = velocity;
    body.state.angular_velocity = spin;
    return body;
}

double energy(const RigidBody& b) {
    return 0.5 * b.mass *
           (b.state.velocity.dot(b.state.velocity) +
            0.4 * b.radius * b.radius * b.state.angular_velocity.dot(b.state.angular_velocity));
}

class Impact : public ::testing::Test {
  protected:
    ode::ThreadGuard guard_;
    ode::ImpactSolver solver_;
};

TEST_F(Impact, BallBall_AnyCutAndSpin_GivesTheImpulsesOfTheFormula) {
    for (int cut = 0; cut <= 80; cut += 5) {
        for (const double spin : {-80.0, 0.0, 35.0}) {
            const double angle = cut * std::numbers::pi / 180;
            const Vec3 normal(-std::cos(angle), -std::sin(angle), 0);
            RigidBody a = ball({0, 0, kRadius}, {3, 0, 0}, {20, 50, spin});
            RigidBody b = ball(a.state.position - normal * (2 * kRadius), {0, 0, 0});
            const Vec3 slip = contact_slip(a, b, normal);
            const RigidBody before = a;
            const ImpulsePair impulse = ball_ball_impact(solver_, a, b, normal, 0.95, 0.06);
            const double along = 0.5 * kMass * 1.95 * 3 * std::cos(angle);
            const double across = std::min(0.06 * along, kMass * slip.length() / 7);
            EXPECT_NEAR(impulse.normal, along, 1e-12);
            EXPECT_NEAR(impulse.tangential, across, 1e-11);
            const Vec3 j = normal * along - slip * (across / slip.length());
            EXPECT_NEAR((a.state.velocity - before.state.velocity - j / kMass).length(), 0, 1e-10);
            EXPECT_NEAR((b.state.velocity + j / kMass).length(), 0, 1e-10);
            const Vec3 spin_change =
                (normal * -kRadius).cross(j) / (0.4 * kMass * kRadius * kRadius);
            EXPECT_NEAR((b.state.angular_velocity - spin_change).length(), 0, 1e-7);
        }
    }
}

TEST_F(Impact, BallBall_ElasticWithoutFriction_KeepsEnergyAndMomentum) {
    RigidBody a = ball({0, 0, 0}, {2, 1, 0.3}, {5, 6, 7});
    const Vec3 direction = Vec3(0.6, 0.64, 0.48);
    RigidBody b = ball(direction * (2 * kRadius), {-1, 0.4, 0}, {-3, 0, 9});
    const double before = energy(a) + energy(b);
    const Vec3 momentum = a.state.velocity + b.state.velocity;
    ball_ball_impact(solver_, a, b, -direction, 1, 0);
    EXPECT_NEAR(energy(a) + energy(b), before, 1e-14);
    EXPECT_NEAR((a.state.velocity + b.state.velocity - momentum).length(), 0, 1e-14);
}

TEST_F(Impact, BallBall_UnequalMasses_ObeyRestitution) {
    RigidBody a = ball({0, 0, 0}, {2, 0, 0});
    RigidBody b = ball({2 * kRadius, 0, 0}, {0, 0, 0});
    b.mass = 3 * kMass;
    ball_ball_impact(solver_, a, b, {-1, 0, 0}, 0.5, 0.1);
    EXPECT_NEAR(b.state.velocity.x - a.state.velocity.x, 1, 1e-12);
    EXPECT_NEAR(a.mass * a.state.velocity.x + b.mass * b.state.velocity.x, 2 * kMass, 1e-14);
}

TEST_F(Impact, BallBall_BarelyApproaching_StillSeparates) {
    RigidBody a = ball({0, 0, 0}, {1e-14, 0, 0});
    RigidBody b = ball({2 * kRadius, 0, 0}, {0, 0, 0});
    ball_ball_impact(solver_, a, b, {-1, 0, 0}, 0.9, 0.1);
    EXPECT_NEAR(b.state.velocity.x - a.state.velocity.x, kMinSeparation, 1e-12);
}

TEST_F(Impact, BallOnSlate_WithSpin_BouncesWithFriction) {
    RigidBody a = ball({0, 0, kRadius}, {1, 0, -2}, {0, 0, 0});
    const ImpulsePair impulse = ball_static_impact(solver_, a, {0, 0, 1}, 0.5, 0.2);
    EXPECT_NEAR(a.state.velocity.z, 1, 1e-12);
    // Sticking would remove 2/7 of the slip; Coulomb's limit 0.2 * 3 m/s is larger.
    EXPECT_NEAR(a.state.velocity.x, 5.0 / 7, 1e-12);
    EXPECT_NEAR(impulse.normal, 3 * kMass, 1e-12);
    EXPECT_NEAR(impulse.tangential, 2.0 / 7 * kMass, 1e-12);
}

TEST(BallFriction_Alciatore, FallsWithSpeed) {
    BallBall law;
    law.friction_model = BallFriction::alciatore;
    EXPECT_NEAR(ball_friction(law, 0), 0.117951, 1e-12);
    EXPECT_NEAR(ball_friction(law, 1), 0.009951 + 0.108 * std::exp(-1.088), 1e-14);
}

TEST(BallFriction_Factor, MultipliesBothLaws) {
    EXPECT_EQ(ball_friction({0.95, 0.06, BallFriction::constant, 1.5}, 3), 1.5 * 0.06);
    EXPECT_EQ(ball_friction({0.95, 0, BallFriction::alciatore, 2.5}, 1),
              2.5 * ball_friction({0.95, 0, BallFriction::alciatore}, 1));
}

/// Han 2005, equations 13 to 17, in its own coordinates (x into the cushion, y along it).
struct HanAnswer {
    double vx, vy;
    Vec3 spin;
};

HanAnswer han(double vx, double vy, const Vec3& w, double e, double mu) {
    const double height = 1.27 * kRadius;
    const double sine = height / kRadius - 1;
    const double cosine = std::sqrt(1 - sine * sine);
    const double inertia = 0.4 * kMass * kRadius * kRadius;
    const double sx = vx * sine + kRadius * w.y;
    const double sy = -vy - kRadius * w.z * cosine + kRadius * w.x * sine;
    const double c = vx * cosine;
    const double along = (1 + e) * c * kMass;
    const double slip = std::sqrt(sx * sx + sy * sy);
    const double across = std::min(slip * 2 * kMass / 7, mu * along);
    const double px = -across * sx / slip * sine - along * cosine;
    const double py = across * sy / slip;
    const double pz = across * sx / slip * cosine - along * sine;
    return {vx + px / kMass, vy + py / kMass,
            w + Vec3(-kRadius / inertia * py * sine, kRadius / inertia * (px * sine - pz * cosine),
                     kRadius / inertia * py * cosine)};
}

TEST(CushionImpact_Han2005, AgreesWithThePapersEquations) {
    const BallCushion law{CushionModel::han2005, 0.85, 0.2};
    const double sine = 0.27;
    const Vec3 inward(-1, 0, 0);
    const Vec3 normal(-std::sqrt(1 - sine * sine), 0, -sine);
    for (const double vy : {-1.0, 0.2, 3.0}) {
        for (const double side : {-60.0, 0.0, 60.0}) {
            for (const double follow : {-40.0, 0.0, 70.0}) {
                const Vec3 spin(5, follow, side);
                RigidBody b = ball({0, 0, kRadius}, {2, vy, 0}, spin);
                cushion_impact(b, inward, normal, law, 0.2);
                const HanAnswer expected = han(2, vy, spin, law.restitution, law.friction);
                EXPECT_NEAR(b.state.velocity.x, expected.vx, 1e-12);
                EXPECT_NEAR(b.state.velocity.y, expected.vy, 1e-12);
                EXPECT_NEAR((b.state.angular_velocity - expected.spin).length(), 0, 1e-9);
            }
        }
    }
}

TEST(CushionImpact_Mirror, ReversesOnlyTheNormalVelocity) {
    const BallCushion law{CushionModel::mirror, 0.7, 0};
    RigidBody b = ball({0, 0, kRadius}, {2, -1, 0}, {3, 4, 5});
    cushion_impact(b, {-1, 0, 0}, {-1, 0, 0}, law, 0.2);
    EXPECT_EQ(b.state.velocity, Vec3(2 - 1.7 * 2, -1, 0));
    EXPECT_EQ(b.state.angular_velocity, Vec3(3, 4, 5));
}

}  // namespace
}  // namespace carom::sim
