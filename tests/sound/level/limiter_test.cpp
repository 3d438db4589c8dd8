#include "sound/level/limiter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/splitmix.h"

namespace carom::sound {
namespace {

/// The highest absolute value at eighths of the sample distance, by a sum of 200 samples under a
/// Hann window.
double brute_force_peak(const std::vector<double>& samples) {
    constexpr int kReach = 100;
    const int count = static_cast<int>(samples.size());
    double most = 0;
    for (int n = 0; n < count; ++n) {
        for (int part = 0; part < 8; ++part) {
            double value = 0;
            for (int k = std::max(0, n - kReach); k <= std::min(count - 1, n + kReach); ++k) {
                const double distance = n + part / 8.0 - k;
                const double angle = std::numbers::pi * distance;
                const double window = std::cos(angle / (2 * kReach + 2));
                value += samples[static_cast<std::size_t>(k)] * window * window *
                         (angle == 0 ? 1 : std::sin(angle) / angle);
            }
            most = std::max(most, std::abs(value));
        }
    }
    return most;
}

/// Noise below 12 kHz with bursts up to 4.
std::vector<double> loud_signal(std::size_t count, std::uint64_t seed) {
    SplitMix64 random(seed);
    std::vector<double> signal(count);
    double before = 0;
    for (std::size_t n = 0; n < count; ++n) {
        const double now = random.between(-1, 1);
        const double loudness = n % 1000 < 80 ? 4 : 0.3;
        signal[n] = loudness * (now + before) / 2;
        before = now;
    }
    return signal;
}

TEST(TruePeak, SineBetweenItsSamples_HasItsAmplitude) {
    // At a quarter of the sample rate, the samples are at 45 degrees: 3 dB below the peak.
    TruePeakMeter meter;
    std::vector<double> sine(4800);
    for (std::size_t n = 0; n < sine.size(); ++n) {
        // Faded in and out: where a sine begins suddenly, its interpolation overshoots.
        const double place = static_cast<double>(n) / static_cast<double>(sine.size());
        sine[n] = std::sin(std::numbers::pi * (static_cast<double>(n) / 2 + 0.25)) *
                  std::sin(std::numbers::pi * place);
    }
    meter.add(sine);
    EXPECT_NEAR(*std::max_element(sine.begin(), sine.end()), std::numbers::sqrt2 / 2, 1e-3);
    EXPECT_NEAR(meter.peak(), 1, 0.005);
}

TEST(TruePeak, Noise_IsWithinATenthOfADecibelOfBruteForce) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const std::vector<double> signal = loud_signal(2400, seed);
        TruePeakMeter meter;
        meter.add(signal);
        EXPECT_NEAR(20 * std::log10(meter.peak() / brute_force_peak(signal)), 0, 0.1);
    }
}

TEST(TruePeak, LastSample_CountsAtOnce) {
    TruePeakMeter meter;
    const std::vector<double> signal{0, 0.7};
    meter.add(signal);
    EXPECT_NEAR(meter.peak(), 0.7, 1e-12);
}

TEST(Limiter, LoudSignal_StaysBelowTheCeiling) {
    for (const double ceiling : {0.9, 0.5}) {
        std::vector<double> left = loud_signal(6000, 7);
        std::vector<double> right = loud_signal(6000, 8);
        Limiter limiter(ceiling);
        limiter.run(left, right);
        for (const std::vector<double>& channel : {left, right}) {
            const double peak = brute_force_peak(channel);
            EXPECT_LE(peak, ceiling * std::pow(10, 0.05 / 20));
            EXPECT_GE(peak, 0.6 * ceiling);
        }
        EXPECT_LT(limiter.lowest_factor(), ceiling / 3);
    }
}

TEST(Limiter, QuietSignal_ComesOutUnchangedAndLater) {
    const std::vector<double> left = loud_signal(3000, 1);
    const std::vector<double> right = loud_signal(3000, 2);
    std::vector<double> limited_left = left;
    std::vector<double> limited_right = right;
    Limiter limiter(20);
    limiter.run(limited_left, limited_right);
    for (std::size_t n = 0; n < left.size(); ++n) {
        const bool is_early = n < Limiter::kDelay;
        ASSERT_EQ(limited_left[n], is_early ? 0 : left[n - Limiter::kDelay]);
        ASSERT_EQ(limited_right[n], is_early ? 0 : right[n - Limiter::kDelay]);
    }
    EXPECT_EQ(limiter.lowest_factor(), 1);
}

TEST(Limiter, Peak_TurnsBothChannelsDownBeforeItComes) {
    std::vector<double> left(12000, 0.1);
    std::vector<double> right(12000, 0.1);
    left[4000] = 2;
    Limiter limiter(1);
    limiter.run(left, right);
    const std::size_t peak = 4000 + Limiter::kDelay;
    EXPECT_LE(left[peak], 1);
    EXPECT_NEAR(left[peak], 1, 0.05);
    EXPECT_NEAR(right[peak], 0.05, 0.003);
    EXPECT_EQ(right[peak - Limiter::kLookAhead - 3], 0.1);
    EXPECT_NEAR(right[peak + 2880], 0.1 - 0.05 / std::numbers::e, 0.002);  // 60 ms later
    double steepest = 0;
    for (std::size_t n = peak - 200; n < peak; ++n) {
        steepest = std::max(steepest, std::abs(right[n + 1] - right[n]));
    }
    EXPECT_LT(steepest, 0.0011);  // 0.05 in 73 steps, rounded up
}

TEST(Limiter, BlockSize_ChangesNoBit) {
    std::vector<double> whole_left = loud_signal(9000, 3);
    std::vector<double> whole_right = loud_signal(9000, 4);
    std::vector<double> left = whole_left;
    std::vector<double> right = whole_right;
    Limiter whole(0.8);
    whole.run(whole_left, whole_right);
    Limiter parts(0.8);
    std::size_t size = 1;
    for (std::size_t first = 0; first < left.size(); first += size, size = size * 7 % 1023 + 1) {
        const std::size_t count = std::min(size, left.size() - first);
        parts.run(std::span(left).subspan(first, count), std::span(right).subspan(first, count));
    }
    EXPECT_EQ(left, whole_left);
    EXPECT_EQ(right, whole_right);
}

}  // namespace
}  // namespace carom::sound
