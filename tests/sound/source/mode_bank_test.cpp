// Sampled banks against the closed form of a single pole.
#include "sound/source/mode_bank.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/sound/closed_forms.h"

namespace carom::sound {
namespace {

constexpr double kStep = 1.0 / 48000;
const std::vector<Partial> kPartials{{{-12000, 12000}, {0.3, -0.2}}, {{-60, 2700}, {-0.1, 0.4}}};

double closed_form(double duration, double time) {
    double sum = 0;
    for (const Partial& partial : kPartials) {
        sum += 2 * (partial.residue * pole_response_at(partial.pole, duration, time)).re;
    }
    return sum;
}

TEST(ModeBank, Samples_AtAnyFractionOfASample_AreTheClosedForm) {
    for (int sixteenth = 0; sixteenth < 16; ++sixteenth) {
        const ModeBank bank(390e-6, kPartials, 1e-15);
        std::vector<double> out(400, 0.0);
        const double first = kStep * (sixteenth / 16.0 - 7);
        bank.add(first, kStep, out);
        for (std::size_t i = 0; i < out.size(); ++i) {
            const double time = first + kStep * static_cast<double>(i);
            EXPECT_NEAR(out[i], closed_form(390e-6, time), 1e-12);
            if (time <= 0) {
                EXPECT_EQ(out[i], 0);
            }
        }
    }
}

TEST(ModeBank, Samples_InBlocks_AreThoseOfOneRow) {
    const ModeBank bank(390e-6, kPartials, 1e-15);
    std::vector<double> whole(1000, 0.0);
    bank.add(-1e-4, kStep, whole);
    for (std::size_t begin = 0; begin < whole.size(); begin += 37) {
        std::vector<double> block(std::min<std::size_t>(37, whole.size() - begin), 0.0);
        bank.add(-1e-4 + kStep * static_cast<double>(begin), kStep, block);
        for (std::size_t i = 0; i < block.size(); ++i) {
            EXPECT_NEAR(block[i], whole[begin + i], 1e-12);
        }
    }
}

TEST(ModeBank, Samples_WithANegativeStep_AreTheMirrorImage) {
    const ModeBank bank(390e-6, kPartials, 1e-6);
    std::vector<double> forward(4000, 0.0);
    std::vector<double> backward(4000, 0.0);
    const double first = -5.3 * kStep;
    bank.add(first, kStep, forward);
    bank.add(first + 3999 * kStep, -kStep, backward);
    for (std::size_t i = 0; i < forward.size(); ++i) {
        EXPECT_NEAR(backward[backward.size() - 1 - i], forward[i], 1e-12);
    }
}

// The highest pressure is about 1, falls to a thousandth in ln 1000 / 50 s, and to the half of that
// in ln 2 / 50 s more, in which it fades out.
TEST(ModeBank, Ring_FadesOutBelowTheLeast) {
    const std::vector<Partial> one{{{-50, 3000}, {0.5, 0}}};
    const ModeBank bank(1e-4, one, 1e-3);
    const ModeBank endless(1e-4, one, 1e-12);
    std::vector<double> out(20000, 0.0);
    std::vector<double> whole(20000, 0.0);
    bank.add(0, kStep, out);
    endless.add(0, kStep, whole);
    const double fade = bank.end() - std::log(2) / 50;
    EXPECT_NEAR(fade, std::log(1000) / 50, 1e-3);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double time = kStep * static_cast<double>(i);
        const double part = std::clamp((time - fade) / (bank.end() - fade), 0.0, 1.0);
        const double factor = 0.5 + 0.5 * std::cos(std::numbers::pi * part);
        ASSERT_NEAR(out[i], factor * whole[i], 1e-12) << time;
        if (time > bank.end()) {
            ASSERT_EQ(out[i], 0);
        }
    }
}

TEST(ModeBank, RingBelowTheLeast_FadesAfterTheForce) {
    const std::vector<Partial> one{{{-50, 3000}, {0.5e-5, 0}}};
    std::vector<double> out(2000, 0.0);
    ModeBank(1e-4, one, 1e-4).add(0, kStep, out);
    for (std::size_t i = 1; i < out.size(); ++i) {
        ASSERT_LT(std::abs(out[i] - out[i - 1]), 4e-6) << i;
    }
    EXPECT_EQ(ModeBank(1e-4, one, 1).end(), 1e-4) << "far below, it does not ring";
}

TEST(ModeBank, Energy_OfARing_IsItsIntegral) {
    // 2 Re(r e^{pt}) has the energy |r|^2 / -Re p + Re(r^2 / -p) over all time.
    const std::vector<Partial> one{{{-80, 3000}, {0.5, 0.2}}};
    const double duration = 1e-6;  // an impulse
    const ModeBank bank(duration, one, 1e-12);
    std::vector<double> out(48000, 0.0);
    bank.add(0, kStep, out);
    double energy = 0;
    for (const double sample : out) {
        energy += sample * sample * kStep;
    }
    const Complex r = one[0].residue;
    const Complex p = one[0].pole;
    const double exact = squared_length(r) / -p.re + ((r * r) / Complex{-p.re, -p.im}).re;
    // Sums instead of integrals err by half of the first sample.
    EXPECT_NEAR(energy, exact, 0.01 * exact);
}

}  // namespace
}  // namespace carom::sound
