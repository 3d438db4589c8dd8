// Rotations of many revolutions between two keys.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/timeline/rotation.h"
#include "sim/timeline/track.h"
#include "timeline_helpers.h"

namespace carom::sim {
namespace {

using test::smooth_key;

constexpr double kPi = std::numbers::pi;

/// The reference orientation by midpoint steps that are so fine that its error is less than a
/// hundredth of the bounds below.
class FineTurn {
  public:
    FineTurn(const Vec3& before, const Vec3& after, double duration)
        : before_(before), after_(after), duration_(duration) {}

    [[nodiscard]] Quat rotation_at(double time) const {
        const auto steps = static_cast<int>(std::ceil(time * 400'000));
        Quat rotation;
        for (int step = 0; step < steps; ++step) {
            const double middle = (step + 0.5) * time / steps;
            const Vec3 velocity = before_ + middle / duration_ * (after_ - before_);
            rotation = rotation_from_vector(time / steps * velocity) * rotation;
        }
        return rotation;
    }

  private:
    Vec3 before_, after_;
    double duration_;
};

Track turning_track(const Vec3& before, const Vec3& after, double duration, const Quat& begin,
                    const Quat& end) {
    return Track("ball", {smooth_key(0, {0, 0, 0}, {0, 0, 0}, begin, before),
                          smooth_key(duration, {0, 0, 0}, {0, 0, 0}, end, after)});
}

TEST(TrackRotation, ConstantSpin_IsKeptOverManyRevolutions) {
    // 50 revolutions and a quarter, in two seconds.
    const Vec3 spin(0, 0, (50.25 * 2 * kPi) / 2);
    const Quat quarter = rotation_from_vector({0, 0, kPi / 2});
    const Track track = turning_track(spin, spin, 2, Quat(), quarter);
    for (const double time : {0.001, 0.37, 1.0, 1.999}) {
        const Quat expected = rotation_from_vector(time * spin);
        EXPECT_LT(angle_between(track.sample(time).orientation, expected), 1e-12);
    }
}

TEST(TrackRotation, LinearlyChangingAxis_FollowsFineIntegration) {
    // A sliding ball: 60 rad/s of side spin become roll; about 8 revolutions in 0.8 s.
    const Vec3 before(20, -60, 10);
    const Vec3 after(-50, 15, 4);
    const double duration = 0.8;
    const FineTurn fine(before, after, duration);
    const Quat begin = rotation_from_vector({0.3, -1, 2});
    const Track track =
        turning_track(before, after, duration, begin, fine.rotation_at(duration) * begin);
    for (const double time : {0.05, 0.21, 0.4, 0.62, 0.79}) {
        const Quat expected = fine.rotation_at(time) * begin;
        EXPECT_LT(angle_between(track.sample(time).orientation, expected), 2e-5) << time;
    }
}

// The angle of a substep is bounded, so the error per radian is, too: a bound per radian holds for
// random pairs.
TEST(TrackRotation, RandomTurns_StayWithinTheBoundPerRadian) {
    test::RandomNumbers numbers(7);
    for (int trial = 0; trial < 12; ++trial) {
        const Vec3 before = numbers.vector(60);
        const Vec3 after = numbers.vector(60);
        const double duration = numbers.between(0.05, 0.5);
        const FineTurn fine(before, after, duration);
        const Track track =
            turning_track(before, after, duration, Quat(), fine.rotation_at(duration));
        const double turn = duration * std::max(before.length(), after.length());
        for (const double fraction : {0.21, 0.5, 0.83}) {
            const double time = fraction * duration;
            const double error =
                angle_between(track.sample(time).orientation, fine.rotation_at(time));
            EXPECT_LT(error, 1e-5 * (1 + turn)) << trial;
        }
    }
}

TEST(TrackRotation, Residual_IsDistributedLinearly) {
    // Without angular velocity, but with keys that differ by 0.4 rad, the rotation is uniform.
    const Track track =
        turning_track({0, 0, 0}, {0, 0, 0}, 2, Quat(), rotation_from_vector({0.4, 0, 0}));
    EXPECT_LT(angle_between(track.sample(0.5).orientation, rotation_from_vector({0.1, 0, 0})),
              1e-15);
    EXPECT_LT(angle_between(track.sample(1.5).orientation, rotation_from_vector({0.3, 0, 0})),
              1e-15);
}

TEST(TrackRotation, AngularVelocity_IsLinearBetweenKeys) {
    const Track track = turning_track({4, 0, 0}, {0, 8, 0}, 2, Quat(), Quat());
    EXPECT_NEAR((track.sample(0.5).angular_velocity - Vec3(3, 2, 0)).length(), 0, 1e-15);
}

TEST(TrackRotation, Orientation_StaysOfUnitLength) {
    const Track track = test::random_track(9, 40);
    for (double time = 0; time < 9; time += 0.013) {
        EXPECT_NEAR(track.sample(time).orientation.length(), 1, 1e-13);
    }
}

}  // namespace
}  // namespace carom::sim
