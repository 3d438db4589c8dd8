#include "sound/rolling/texture_oscillator.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/splitmix.h"

namespace carom::sound {
namespace {

/// The value at a place (m), read at this speed.
double value_of(TextureOscillator& texture, double place, double speed) {
    const TextureOscillator::Weights now = texture.weights(speed);
    return texture.value(place, now, now, 0);
}

/// The root mean square along 300 m.
double measured_strength(TextureOscillator reader, double speed) {
    double sum = 0;
    constexpr int kCount = 400000;
    for (int n = 0; n < kCount; ++n) {
        const double value = value_of(reader, n * 300.0 / kCount, speed);
        sum += value * value;
    }
    return std::sqrt(sum / kCount);
}

TEST(Texture, RootMeanSquare_IsItsStrength) {
    for (const double speed : {0.1, 1.0, 5.0, 15.0}) {
        const TextureOscillator reader(3, kCloth);
        EXPECT_NEAR(measured_strength(reader, speed) / reader.strength(speed), 1, 0.03) << speed;
    }
}

// Seven octaves of equal height, whose slopes go with 1 / lambda, weighted by Remington's filter.
TEST(Texture, Strength_IsThatOfTheFormula) {
    for (const double speed : {0.5, 2.0, 13.0}) {
        double all = 0;
        double heard = 0;
        for (double length = 0.0384; length > 0.0005; length /= 2) {
            const double ka = 2 * std::numbers::pi / length * 0.0015;
            const double power = 1 / (length * length) / (1 + std::numbers::pi / 4 * ka * ka * ka);
            const double frequency = speed / (3 * length);
            const double low = frequency * frequency / (frequency * frequency + 400);
            const double high = std::fmax(0, std::fmin(1, (19200 - speed / length) / 4800));
            all += power;
            heard += power * low * low * high * high;
        }
        EXPECT_NEAR(TextureOscillator(1, kCloth).strength(speed), std::sqrt(heard / all), 1e-12);
    }
}

TEST(Texture, AnyOrder_GivesTheSameBits) {
    TextureOscillator forward(7, kCloth);
    std::vector<double> values;
    for (int n = 0; n < 5000; ++n) {
        values.push_back(value_of(forward, 1000 + n * 1.3e-4, 2));
    }
    TextureOscillator backward(7, kCloth);
    for (int n = 4999; n >= 0; --n) {
        ASSERT_EQ(value_of(backward, 1000 + n * 1.3e-4, 2), values[static_cast<std::size_t>(n)]);
    }
    SplitMix64 random(1);
    for (int i = 0; i < 5000; ++i) {
        const auto n = static_cast<int>(random.between(0, 5000));
        ASSERT_EQ(value_of(forward, 1000 + n * 1.3e-4, 2), values[static_cast<std::size_t>(n)]);
    }
}

TEST(Texture, Values_AreContinuous) {
    TextureOscillator reader(2, kSolid);
    double before = value_of(reader, 5, 1);
    double steepest = 0;
    for (int n = 1; n < 100000; ++n) {
        const double now = value_of(reader, 5 + n * 1e-7, 1);
        steepest = std::fmax(steepest, std::abs(now - before));
        before = now;
    }
    // A step of 0.1 um in cells of 75 um and more, of values of the order of 1.
    EXPECT_LT(steepest, 0.01);
    EXPECT_GT(steepest, 1e-4);
}

TEST(Texture, OtherSeed_IsAnotherTexture) {
    TextureOscillator one(1, kCloth);
    TextureOscillator other(2, kCloth);
    double product = 0;
    for (int n = 0; n < 100000; ++n) {
        product += value_of(one, n * 1e-3, 3) * value_of(other, n * 1e-3, 3);
    }
    EXPECT_LT(std::abs(product / 100000), 0.03);
}

TEST(Texture, WithoutMotion_IsSilent) {
    TextureOscillator reader(1, kCloth);
    EXPECT_EQ(value_of(reader, 0.123, 0), 0);
    EXPECT_EQ(reader.strength(0), 0);
}

TEST(Texture, CellsFasterThanTheSamples_AreLeftOut) {
    TextureOscillator reader(1, kCloth);
    EXPECT_EQ(value_of(reader, 0.123, 0.0384 * 0.4 * 48000), 0);
    EXPECT_EQ(reader.strength(0.0384 * 0.4 * 48000), 0);
    EXPECT_GT(reader.strength(0.0384 * 0.39 * 48000), 0);
}

}  // namespace
}  // namespace carom::sound
