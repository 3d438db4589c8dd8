#include "sound/level/loudness.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sound/level/decibels.h"
#include "sound/sound_scene.h"

namespace carom::sound {
namespace {

/// A sine of 1 kHz in both channels, in stretches of (level in dB of its peak, duration in s).
double loudness_of(const std::vector<std::pair<double, double>>& stretches) {
    LoudnessMeter meter;
    std::int64_t n = 0;
    for (const auto& [level, duration] : stretches) {
        std::vector<double> samples(static_cast<std::size_t>(duration * kSampleRate));
        for (double& sample : samples) {
            sample = factor_of(level) *
                     std::sin(2 * std::numbers::pi * 1000 * static_cast<double>(n++) / kSampleRate);
        }
        meter.add(samples, samples);
    }
    return meter.integrated();
}

// The test signals 1 to 3 and 5 of EBU Tech 3341, whose tolerance is 0.1 LU.
TEST(LoudnessMeter, TestSignalsOfTheEbu_AreAtTheirLoudness) {
    EXPECT_NEAR(loudness_of({{-23, 20}}), -23, 0.1);
    EXPECT_NEAR(loudness_of({{-33, 20}}), -33, 0.1);
    EXPECT_NEAR(loudness_of({{-36, 10}, {-23, 60}, {-36, 10}}), -23, 0.1);
    EXPECT_NEAR(loudness_of({{-26, 20}, {-20, 20.1}, {-26, 20}}), -23, 0.1);
}

TEST(LoudnessMeter, Silence_HasNoLoudness) {
    EXPECT_EQ(loudness_of({}), -std::numeric_limits<double>::infinity());
    LoudnessMeter meter;
    const std::vector<double> silence(kSampleRate, 0.0);
    meter.add(silence, silence);
    EXPECT_EQ(meter.integrated(), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(meter.true_peak(), 0);
}

TEST(LoudnessMeter, TruePeak_IsTheHigherOneOfBothChannels) {
    LoudnessMeter meter;
    const std::vector<double> loud{0, 0, 0.5, 0, 0};
    const std::vector<double> quiet{0, 0, -0.25, 0, 0};
    meter.add(quiet, loud);
    EXPECT_NEAR(meter.true_peak(), 0.5, 1e-12);
}

}  // namespace
}  // namespace carom::sound
