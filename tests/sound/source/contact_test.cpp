// Durations and forces of contacts, against the table of pool balls and the powers of Hertz's law.
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

Contact at_speed(double speed) {
    return hertz_contact(pool_balls(), speed * kMass / 2 * 1.95);
}

// From the formulas, with 1/E = 2 (1 - 0.34^2) / 5.84 GPa: E = 3.30168 GPa.
TEST(Contact, PoolBalls_AtOneMetrePerSecond_HaveTheDurationAndForceOfHertz) {
    const double modulus = 5.84e9 / (2 * (1 - 0.34 * 0.34));
    EXPECT_NEAR(pool_balls().reduced_modulus, modulus, 1);
    const double overlap =
        std::pow(15 * (kMass / 2) / (16 * modulus * std::sqrt(0.028575 / 2)), 0.4);
    const Contact contact = at_speed(1);
    EXPECT_NEAR(contact.speed, 1, 1e-12);
    EXPECT_NEAR(contact.overlap, overlap, 1e-15);
    EXPECT_NEAR(contact.duration, 390e-6, 0.5e-6);
    EXPECT_NEAR(contact.force, 802, 0.5);
    EXPECT_NEAR(contact.overlap, 132.5e-6, 0.1e-6);
}

TEST(Contact, PoolBalls_SlowAndFast_FollowTheTable) {
    EXPECT_NEAR(at_speed(0.1).duration, 618e-6, 0.5e-6);
    EXPECT_NEAR(at_speed(0.1).force, 50.6, 0.5);
    EXPECT_NEAR(at_speed(5).duration, 283e-6, 0.5e-6);
    EXPECT_NEAR(at_speed(5).force, 5530, 10);
    EXPECT_NEAR(at_speed(5).overlap, 480e-6, 1.5e-6);
}

TEST(Contact, Duration_AndForce_ArePowersOfTheSpeed) {
    const Contact slow = at_speed(0.7);
    const Contact fast = at_speed(0.7 * 32);
    EXPECT_NEAR(slow.duration / fast.duration, 2, 1e-12);
    EXPECT_NEAR(fast.force / slow.force, 64, 1e-10);
}

// The energy of the approach is that of the compressed contact: m v^2 / 2 = 2/5 F d.
TEST(Contact, Energy_AtTheHighestOverlap_IsThatOfTheApproach) {
    const Contact contact = at_speed(3);
    EXPECT_NEAR(0.4 * contact.force * contact.overlap, 0.5 * kMass / 2 * 9, 1e-12);
}

TEST(Contact, Reduced_WithAnInfinitePartner_IsTheOther) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(reduced(0.2, kInfinite), 0.2);
    EXPECT_EQ(reduced(kInfinite, 0.3), 0.3);
    EXPECT_NEAR(reduced(0.2, 0.3), 0.12, 1e-15);
}

TEST(Contact, Structures_FollowTheirPowerOfTheSpeed) {
    const Structures structures = default_structures(kMass);
    // A cushion is a spring: its time depends on the mass alone.
    EXPECT_NEAR(structure_contact_time(structures.cushion, kMass, 0.1), 5.5e-3, 0.05e-3);
    EXPECT_EQ(structure_contact_time(structures.cushion, kMass, 0.1),
              structure_contact_time(structures.cushion, kMass, 1));
    EXPECT_NEAR(default_structures(4 * kMass).cushion.contact, 2 * structures.cushion.contact,
                1e-12);
    // 1 m/s towards the bed, which gives half of it back.
    EXPECT_NEAR(structure_contact_time(structures.bed, kMass, kMass * 1.5), 1e-3, 1e-15);
    EXPECT_NEAR(structure_contact_time(structures.bed, kMass, 32 * kMass * 1.5), 0.5e-3, 1e-15);
    // A stick that gives 3 m/s.
    EXPECT_NEAR(structure_contact_time(structures.stick, kMass, kMass * 3), 1.3e-3, 1e-15);
}

}  // namespace
}  // namespace carom::sound
