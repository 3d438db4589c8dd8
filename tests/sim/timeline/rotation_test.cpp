#include "sim/timeline/rotation.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "timeline_helpers.h"

namespace carom::sim {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Rotation, Vector_TurnsRightHanded) {
    const Quat quarter = rotation_from_vector({0, 0, kPi / 2});
    EXPECT_NEAR((Vec3(1, 0, 0) * quarter - Vec3(0, 1, 0)).length(), 0, 1e-15);
}

TEST(Rotation, Exponential_IsOfUnitLengthAndMatchesSineAndCosine) {
    test::RandomNumbers numbers(1);
    for (int trial = 0; trial < 1000; ++trial) {
        const double angle = trial < 500 ? numbers.between(0, 0.6) : numbers.between(0, 500);
        const Vec3 axis = numbers.vector(1).normalized();
        const Quat rotation = rotation_from_vector(angle * axis);
        EXPECT_NEAR(rotation.length(), 1, 3e-16);
        EXPECT_NEAR(rotation.r, std::cos(angle / 2), 2e-13);
        EXPECT_NEAR((rotation.v - std::sin(angle / 2) * axis).length(), 0, 2e-13);
    }
}

TEST(Rotation, Logarithm_InvertsTheExponential) {
    test::RandomNumbers numbers(2);
    for (int trial = 0; trial < 1000; ++trial) {
        const double angle = kPi * std::pow(10.0, numbers.between(-12, 0));
        const Vec3 vector = angle * numbers.vector(1).normalized();
        const Quat rotation = rotation_from_vector(vector);
        EXPECT_NEAR((rotation_vector(rotation) - vector).length(), 0, 4e-15 * angle + 1e-30);
        EXPECT_NEAR((rotation_vector(-rotation) - vector).length(), 0, 4e-15 * angle + 1e-30);
    }
}

TEST(Rotation, ZeroVector_IsExactlyTheIdentity) {
    EXPECT_EQ(rotation_from_vector({0, 0, 0}), Quat());
    EXPECT_EQ(rotation_vector(Quat()), Vec3(0));
    EXPECT_EQ(angle_between(Quat(), Quat()), 0);
}

// The reference: 4096 steps of the midpoint rule, whose relative error is about 1e-8 here and which
// needs no commutator.
Quat integrate_finely(const Vec3& before, const Vec3& after, double duration) {
    constexpr int kSteps = 4096;
    Quat rotation;
    for (int step = 0; step < kSteps; ++step) {
        const Vec3 middle = before + (step + 0.5) / kSteps * (after - before);
        rotation = rotation_from_vector(duration / kSteps * middle) * rotation;
    }
    return rotation;
}

// The error of one step is of fifth order in its length. This tests the sign of the commutator:
// with the wrong sign the error would be twice that without the commutator.
TEST(Rotation, MagnusStep_FollowsWorldFrameVelocityToFourthOrder) {
    const Vec3 before(3, 0, 1);
    const Vec3 slope(-15, 20, -10);
    double previous = 0;
    for (const double duration : {0.2, 0.1, 0.05}) {
        const Vec3 after = before + duration * slope;
        const Quat reference = integrate_finely(before, after, duration);
        const double error = angle_between(magnus_step(before, after, duration), reference);
        const Quat without = rotation_from_vector(0.5 * duration * (before + after));
        EXPECT_LT(error, 0.1 * angle_between(without, reference));
        if (previous > 0) {
            EXPECT_NEAR(std::log2(previous / error), 5, 0.3);
        }
        previous = error;
    }
}

TEST(Rotation, MagnusStep_ParallelVelocitiesAreExactForAnyTurn) {
    const Vec3 axis = Vec3(1, 2, 3).normalized();
    const Quat turned = magnus_step(100.0 * axis, 20.0 * axis, 2);
    EXPECT_LT(angle_between(turned, rotation_from_vector(120.0 * axis)), 1e-13);
}

}  // namespace
}  // namespace carom::sim
