// Modes of resonators and of boxes.
#include "sound/source/mode_sound.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sound/source/defaults.h"

namespace carom::sound {
namespace {

TEST(ModeSound, Pole_OfAMode_HasItsFrequencyAndQ) {
    const Complex pole = mode_pole({440, 10, 1});
    EXPECT_NEAR(std::sqrt(squared_length(pole)), 2 * M_PI * 440, 1e-9);
    EXPECT_NEAR(-pole.re, 2 * M_PI * 440 / 20, 1e-9);
}

TEST(ModeSound, Residue_AfterAnImpulse_BeginsWithTheGain) {
    const Complex residue = mode_residue({440, 3, 0.7});
    EXPECT_NEAR(2 * residue.re, 0.7, 1e-12);
}

TEST(ModeSound, Domino_OfPlastic_HasItsTwoFlatModes) {
    const double mass = 1800 * 0.010 * 0.032 * 0.060;
    const std::vector<Mode> modes =
        box_modes({0.010, 0.032, 0.060}, mass, default_material("tile"), {1, 0, 0});
    ASSERT_EQ(modes.size(), 2);
    EXPECT_NEAR(modes[0].frequency, 5830, 20);
    EXPECT_NEAR(modes[1].frequency, 14100, 30);
    EXPECT_NEAR(modes[0].q, 1 / 0.03, 1e-9);
    EXPECT_NEAR(modes[0].gain, 2, 1e-12);
    EXPECT_NEAR(modes[1].gain, 1, 1e-12);
}

TEST(ModeSound, Plank_OfMaple_BendsAt890Hz) {
    const std::vector<Mode> modes = bar_modes(0.3, 0.02, 700, default_material("wood"));
    EXPECT_NEAR(modes[0].frequency, 890, 5);
    EXPECT_NEAR(modes[1].frequency, 2390, 15);
}

TEST(ModeSound, Box_HitObliquely_BendsAlongBothShortEdges) {
    const double half = std::sqrt(0.5);
    const std::vector<Mode> modes =
        box_modes({0.06, 0.01, 0.03}, 0.03, default_material("tile"), {0, half, -half});
    ASSERT_EQ(modes.size(), 4);
    EXPECT_NEAR(modes[0].gain, 2 * half, 1e-12);
    EXPECT_NEAR(modes[2].gain, 2 * half, 1e-12);
    EXPECT_GT(modes[2].frequency, modes[0].frequency);  // thicker
}

TEST(ModeSound, Box_HitOnItsEnd_DoesNotBend) {
    EXPECT_TRUE(box_modes({0.06, 0.01, 0.03}, 0.03, default_material("tile"), {1, 0, 0}).empty());
}

}  // namespace
}  // namespace carom::sound
