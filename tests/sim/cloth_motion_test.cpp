// Closed-form motion of one ball on the cloth (Marlow, The Physics of Pocket Billiards, 1995,
// chapter 2).
#include "sim/motion/cloth_motion.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/splitmix.h"

namespace carom::sim {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kGravity = 9.81;
const FrictionCoefficients kLaw{0.2, 0.01, 0.0127};

MotionState moving(const Vec3& velocity, const Vec3& spin) {
    MotionState state;
    state.position = {0, 0, kRadius};
    state.velocity = velocity;
    state.angular_velocity = spin;
    return state;
}

TEST(ClothMotion_StunShot, RollsAtFiveSeventhsOfItsSpeed) {
    for (const double speed : {0.1, 1.0, 5.0, 15.0}) {
        const MotionSegment slide =
            cloth_segment(2.0, moving({speed, 0, 0}, {0, 0, 0}), kRadius, kGravity, kLaw);
        ASSERT_EQ(slide.kind, MotionKind::sliding);
        EXPECT_NEAR(slide.end - 2.0, 2 * speed / (7 * 0.2 * kGravity), 1e-14);
        const MotionState end = slide.state_at(slide.end);
        EXPECT_NEAR(end.velocity.x, speed * 5 / 7, 1e-13 * speed);
        EXPECT_NEAR(end.angular_velocity.y, speed * 5 / 7 / kRadius, 1e-11 * speed / kRadius);
        EXPECT_NEAR(end.position.x, 12 * speed * speed / (49 * 0.2 * kGravity), 1e-12 * speed);
    }
}

TEST(ClothMotion_DrawShot, ComesBackIfTheSpinIsLargeEnough) {
    // v_end = 5/7 v + 2/7 R w for spin about the axis of rolling; here it is negative.
    const double spin = -4 / kRadius;
    const MotionSegment slide =
        cloth_segment(0, moving({1, 0, 0}, {0, spin, 0}), kRadius, kGravity, kLaw);
    const MotionState end = slide.state_at(slide.end);
    EXPECT_NEAR(end.velocity.x, 5.0 / 7 + 2.0 / 7 * kRadius * spin, 1e-13);
}

TEST(ClothMotion_Masse, FollowsAParabolaToItsRollingVelocity) {
    const MotionState start = moving({2, 0.5, 0}, {60, -30, 20});
    const MotionSegment slide = cloth_segment(0, start, kRadius, kGravity, kLaw);
    const MotionState end = slide.state_at(slide.end);
    // u' = -7/2 mu g, and the velocity changes by 2/7 of the slip that has vanished.
    const Vec3 slip = slip_velocity(start, kRadius);
    const Vec3 expected = start.velocity - slip * (2.0 / 7);
    EXPECT_NEAR((end.velocity - expected).length(), 0, 1e-13);
    EXPECT_NEAR(slip_velocity(end, kRadius).length(), 0, 1e-12);
}

TEST(ClothMotion_Rolling, StopsAfterVSquaredOverTwoMuG) {
    const MotionState start =
        moving({0.6, 0.8, 0}, Vec3(0, 0, 1).cross(Vec3(0.6, 0.8, 0)) / kRadius);
    const MotionSegment roll = cloth_segment(0, start, kRadius, kGravity, kLaw);
    ASSERT_EQ(roll.kind, MotionKind::rolling);
    EXPECT_NEAR(roll.end, 1 / (0.01 * kGravity), 1e-12);
    const MotionState end = roll.state_at(roll.end);
    EXPECT_NEAR(end.position.length(), Vec3(0.6, 0.8, 0).length() / (2 * 0.01 * kGravity), 1e-3);
    EXPECT_NEAR(Vec2(end.position.x, end.position.y).length(), 1 / (2 * 0.01 * kGravity), 1e-12);
}

TEST(ClothMotion_SpinAboutTheVertical, DecaysAtAConstantRate) {
    const MotionSegment spin =
        cloth_segment(0, moving({0, 0, 0}, {0, 0, -50}), kRadius, kGravity, kLaw);
    ASSERT_EQ(spin.kind, MotionKind::spinning);
    EXPECT_NEAR(spin.end, 50 / (2.5 * 0.0127 * kGravity / kRadius), 1e-12);
    EXPECT_NEAR(spin.angular_velocity_at(spin.end / 2).z, -25, 1e-11);
}

TEST(ClothMotion_NoVelocity, Rests) {
    const MotionSegment rest =
        cloth_segment(0, moving({0, 0, 0}, {0, 0, 0}), kRadius, kGravity, kLaw);
    EXPECT_EQ(rest.kind, MotionKind::resting);
    EXPECT_EQ(rest.end, kNever);
}

TEST(ClothMotion_WithoutFriction, SlidesForever) {
    const MotionSegment slide =
        cloth_segment(0, moving({1, 0, 0}, {0, 0, 0}), kRadius, kGravity, {0, 0, 0});
    EXPECT_EQ(slide.kind, MotionKind::sliding);
    EXPECT_EQ(slide.end, kNever);
}

/// Slip and velocity of a ball that slides off level: Runge-Kutta in equal steps.
void slide_off_level(Vec3& slip, Vec3& position, Vec3& velocity, const Vec3& pull, double friction,
                     double duration) {
    constexpr int kSteps = 20000;
    const double h = duration / kSteps;
    const auto direction = [](const Vec3& u) { return u / u.length(); };
    const auto slope = [&](const Vec3& u) { return pull - direction(u) * (3.5 * friction); };
    for (int i = 0; i < kSteps; ++i) {
        const Vec3 k1 = slope(slip);
        const Vec3 k2 = slope(slip + k1 * (h / 2));
        const Vec3 k3 = slope(slip + k2 * (h / 2));
        const Vec3 k4 = slope(slip + k3 * h);
        const Vec3 middle = slip + (k1 + k2) * (h / 4);
        const Vec3 acceleration = pull - direction(middle) * friction;
        position += velocity * h + acceleration * (h * h / 2);
        velocity += acceleration * h;
        slip += (k1 + k2 * 2 + k3 * 2 + k4) * (h / 6);
    }
}

TEST(ClothMotion_SlidingOffLevel, TurnsDownhill) {
    const Vec3 pull(0.6, 0.2, 0);
    MotionState state = moving({-1, 2, 0}, {30, 10, 5});
    Vec3 slip = slip_velocity(state, kRadius);
    Vec3 position = state.position;
    Vec3 velocity = state.velocity;
    constexpr double kDuration = 0.3;
    slide_off_level(slip, position, velocity, pull, kLaw.sliding_friction * kGravity, kDuration);
    double time = 0;
    int count = 0;
    for (; time < kDuration; ++count) {
        const MotionSegment slide = cloth_segment(time, state, kRadius, kGravity, kLaw, pull);
        ASSERT_EQ(slide.kind, MotionKind::sliding);
        time = std::min(slide.end, kDuration);
        state = slide.state_at(time);
    }
    EXPECT_GT(count, 5);
    EXPECT_LT(count, 300);
    EXPECT_NEAR((state.position - position).length(), 0, 2e-7);
    EXPECT_NEAR((slip_velocity(state, kRadius) - slip).length(), 0, 1e-5);
}

TEST(ClothMotion_OffLevelAtRandom, LosesEnergyAndNeedsFewPieces) {
    SplitMix64 random(1);
    for (int i = 0; i < 300; ++i) {
        const Vec3 pull = Vec3(random.between(-1, 1), random.between(-1, 1), 0) *
                          std::pow(10, random.between(-3, 1));
        const FrictionCoefficients law{random.between(0.05, 0.4),
                                       i % 5 == 0 ? 0 : random.between(0, 0.03),
                                       random.between(0, 0.02)};
        const Vec3 velocity = Vec3(random.between(-1, 1), random.between(-1, 1), 0) *
                              std::pow(10, random.between(-4, 0.5));
        const Vec3 spin =
            Vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)) *
            (i % 3 == 0 ? 0 : 100);
        MotionState state = moving(velocity, spin);
        const auto energy = [&] {
            return 0.5 * state.velocity.dot(state.velocity) +
                   0.2 * kRadius * kRadius * state.angular_velocity.dot(state.angular_velocity) -
                   pull.dot(state.position);
        };
        double time = 0;
        int count = 0;
        for (; time < 3; ++count) {
            const MotionSegment segment = cloth_segment(time, state, kRadius, kGravity, law, pull);
            ASSERT_GT(segment.end, time) << i;
            const double before = energy();
            time = std::min(segment.end, 3.0);
            state = segment.state_at(time);
            EXPECT_LE(energy(), before + 1e-6 * (1 + std::abs(before))) << i;
            if (segment.kind == MotionKind::resting) {
                EXPECT_FALSE(rolls_off(kGravity, law, pull)) << i;
                break;
            }
        }
        EXPECT_LT(count, 3100) << i;
    }
}

}  // namespace
}  // namespace carom::sim
