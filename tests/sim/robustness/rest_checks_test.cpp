// The check of what is at rest, on islands whose balance is known.
#include "rest_checks.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nonnegative_least_squares.h"
#include "sim/numeric/tolerances.h"
#include "tests/sim/shots.h"

namespace carom::sim::test {
namespace {

Body box(const std::string& name, const Vec3& size, const Vec3& position, double angle = 0) {
    Body body;
    body.name = name;
    body.shape = Box{size};
    body.mass = 0.1;
    body.material = "wood";
    body.pose = {position, Quat(std::cos(angle / 2), Vec3(0, std::sin(angle / 2), 0))};
    return body;
}

/// A timeline in which the bodies of the world keep their velocities, and are where they are at
/// half a second.
Timeline moving_evenly(const WorldDescription& world) {
    Timeline timeline;
    timeline.end_time = 1;
    for (const Body& body : world.bodies) {
        if (body.kind == BodyKind::dynamic) {
            Key key;
            key.position = body.pose.position - body.velocity * 0.5;
            key.orientation = body.pose.orientation;
            key.velocity_in = key.velocity_out = body.velocity;
            Key end = key;
            end.time = 1;
            end.position += body.velocity;
            timeline.tracks.emplace_back(body.name, std::vector<Key>{key, end});
        }
    }
    return timeline;
}

std::vector<std::string> faults_of(const WorldDescription& world) {
    return find_unheld(world, moving_evenly(world), 0.5, [](const Body&) { return true; });
}

WorldDescription wooden_world(double friction) {
    WorldDescription world = cloth_world(1);
    world.contact_law.otherwise = {0, friction, 0};
    return world;
}

TEST(NonnegativeLeastSquares_OfSmallProblems, AreThoseByHand) {
    // The unconstrained solution is (3, -1); without the second column 11/5 is best.
    const std::vector<double> residual = nonnegative_residual({{1, 2}, {1, 1}}, {2, 5});
    EXPECT_NEAR(residual[0], 2 - 12.0 / 5, 1e-12);
    EXPECT_NEAR(residual[1], 5 - 24.0 / 5, 1e-12);
    for (const double value : nonnegative_residual({{1, 0}, {1, 1}, {0, 1}}, {3, 2})) {
        EXPECT_NEAR(value, 0, 1e-12);
    }
    EXPECT_EQ(nonnegative_residual({{-1, 0}}, {3, 2}), (std::vector<double>{3, 2}));
    EXPECT_EQ(nonnegative_residual({}, {3}), (std::vector<double>{3}));
}

TEST(RestingBox_OnASlope, IsHeldUpToItsAngleOfFriction) {
    constexpr double kFriction = 0.3;
    for (const double factor : {0.5, 0.99, 1.03}) {
        const double angle = std::atan(kFriction * factor);
        const Vec3 up(std::sin(angle), 0, std::cos(angle));
        WorldDescription world = wooden_world(kFriction);
        world.bodies = {box("slope", {1, 1, 0.02}, {0, 0, 1}, angle),
                        box("box", {0.05, 0.05, 0.05}, Vec3(0, 0, 1) + up * 0.035, angle)};
        world.bodies[0].kind = BodyKind::fixed;
        EXPECT_EQ(faults_of(world).size(), factor < 1 ? 0U : 1U) << factor;
    }
}

TEST(RestingBall_OnASlope, IsHeldUpToItsRollingResistance) {
    constexpr double kRolling = 0.05;
    for (const double factor : {0.9, 1.2}) {
        const double angle = std::atan(1.4 * kRolling * factor);
        const Vec3 up(std::sin(angle), 0, std::cos(angle));
        WorldDescription world = wooden_world(0.3);
        world.contact_law.otherwise.rolling_friction = kRolling;
        world.bodies = {box("slope", {1, 1, 0.02}, {0, 0, 1}, angle), ball("ball", 0, 0)};
        world.bodies[0].kind = BodyKind::fixed;
        world.bodies[1].pose.position = Vec3(0, 0, 1) + up * (0.01 + kRadius);
        EXPECT_EQ(faults_of(world).size(), factor < 1 ? 0U : 1U) << factor;
    }
}

TEST(RestingBall_OnOneThatMoves, IsHeldIfThatCreeps) {
    constexpr double kSlope = 0.1;
    for (const double speed : {1e-6, 0.009, 0.011}) {
        WorldDescription world = wooden_world(0.3);
        world.gravity = Vec3(std::sin(kSlope), 0, -std::cos(kSlope)) * kGravity;
        world.bodies = {ball("ball", 0, 0), ball("lower", 2 * kRadius, 0, {0, speed, 0})};
        EXPECT_EQ(faults_of(world).size(), speed < kSleepSpeed ? 0U : 1U) << speed;
    }
}

TEST(RestingIsland_WithoutSupport, IsFoundAsOne) {
    WorldDescription world = wooden_world(0.5);
    world.bodies = {box("low", {0.05, 0.05, 0.05}, {0, 0, 0.0252}),
                    box("top", {0.05, 0.05, 0.05}, {0, 0, 0.0752})};
    EXPECT_THAT(faults_of(world),
                testing::ElementsAre("'low' rests without being held: 1.0000 of its "
                                     "weight is missing, in an island of 2"));
    world.bodies[0].pose.position.z = 0.025;
    world.bodies[1].pose.position.z = 0.075;
    EXPECT_THAT(faults_of(world), testing::IsEmpty());
    world.bodies[1].pose.position.x = 0.0252;
    EXPECT_EQ(faults_of(world).size(), 1U) << "the top box would tip";
}

TEST(RestingBody_InsideOfAnother, IsFound) {
    WorldDescription world = wooden_world(0.5);
    world.bodies = {box("box", {0.05, 0.05, 0.05}, {0, 0, 0.0249})};
    EXPECT_THAT(faults_of(world), testing::Each("'box' rests 0.100 mm inside of 'cloth'"));
    EXPECT_FALSE(faults_of(world).empty());
}

}  // namespace
}  // namespace carom::sim::test
