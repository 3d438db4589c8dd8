// Durations of contacts, against the table of pool balls and the powers of Hertz's law.
#include "sound/source/contact.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "sound/source/defaults.h"

namespace carom::sound {
namespace {

constexpr double kMass = 0.1701;

ContactPair pool_balls() {
    const Material phenolic = default_material("ball");
    return {kMass / 2, 0.028575 / 2, reduced_modulus(phenolic, phenolic), 0.95};
}

double time_at(double speed) {
    return hertz_contact_time(pool_balls(), speed * kMass / 2 * 1.95);
}

// From the formulas, with 1/E = 2 (1 - 0.34^2) / 5.84 GPa: E = 3.30168 GPa.
TEST(Contact, PoolBalls_AtOneMetrePerSecond_HaveTheDurationOfHertz) {
    const double modulus = 5.84e9 / (2 * (1 - 0.34 * 0.34));
    EXPECT_NEAR(pool_balls().reduced_modulus, modulus, 1);
    const double indentation =
        std::pow(15 * (kMass / 2) / (16 * modulus * std::sqrt(0.028575 / 2)), 0.4);
    EXPECT_NEAR(indentation, 132.5e-6, 0.1e-6);
    EXPECT_NEAR(time_at(1), 2.943 * indentation, 1e-15);
    EXPECT_NEAR(time_at(1), 390e-6, 0.5e-6);
}

TEST(Contact, PoolBalls_SlowAndFast_FollowTheTable) {
    EXPECT_NEAR(time_at(0.1), 618e-6, 0.5e-6);
    EXPECT_NEAR(time_at(5), 283e-6, 0.5e-6);
}

TEST(Contact, Duration_IsAPowerOfTheSpeed) {
    EXPECT_NEAR(time_at(0.7) / time_at(0.7 * 32), 2, 1e-12);
}

TEST(Contact, Reduced_WithAnInfinitePartner_IsTheOther) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(reduced(0.2, kInfinite), 0.2);
    EXPECT_EQ(reduced(kInfinite, 0.3), 0.3);
    EXPECT_NEAR(reduced(0.2, 0.3), 0.12, 1e-15);
}

TEST(Contact, Resonators_FollowTheirPowerOfTheSpeed) {
    const Resonators resonators = default_resonators(kMass);
    // A cushion is a spring: its time depends on the mass alone.
    EXPECT_NEAR(resonator_contact_time(resonators.cushion, kMass, 0.1), 5.5e-3, 0.05e-3);
    EXPECT_EQ(resonator_contact_time(resonators.cushion, kMass, 0.1),
              resonator_contact_time(resonators.cushion, kMass, 1));
    EXPECT_NEAR(default_resonators(4 * kMass).cushion.contact, 2 * resonators.cushion.contact,
                1e-12);
    // 1 m/s towards the bed, which gives half of it back.
    EXPECT_NEAR(resonator_contact_time(resonators.bed, kMass, kMass * 1.5), 1e-3, 1e-15);
    EXPECT_NEAR(resonator_contact_time(resonators.bed, kMass, 32 * kMass * 1.5), 0.5e-3, 1e-15);
    // A stick that gives 3 m/s.
    EXPECT_NEAR(resonator_contact_time(resonators.stick, kMass, kMass * 3), 1.3e-3, 1e-15);
}

}  // namespace
}  // namespace carom::sound
