// What `carom sound` writes of impacts, against the motion from which it is computed.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "sound/level/true_peak.h"
#include "tests/pipeline/cli/sound_fixture.h"

namespace carom::cli {
namespace {

using carom::testing::HeardRow;
using carom::testing::in_full_scale;
using carom::testing::kSampleRate;
using carom::testing::peak_index;
using carom::testing::SoundCommands;
using carom::testing::spectral_peak;
using carom::testing::WavSamples;
using carom::testing::write_text;

class SoundImpacts : public SoundCommands {};

std::int64_t sample_of(double time) {
    return std::lround(time * kSampleRate);
}

/// The time in which what sounds after the impact falls to 37 %, s in the scene: that of the
/// slowest mode of the surface, Q / (pi f), with the modes of sound/source/defaults.cpp.
double decay_of(const HeardRow& row) {
    if (row.b == "cloth") {
        return 10 / (M_PI * 113);
    }
    if (row.kind == "strike") {
        return 12 / (M_PI * 310);
    }
    // A ball has no modes, and its pulse ends within a fraction of a millisecond.
    const bool is_surface = row.b == "cushion" || row.b == "pocket" || row.b == "rail";
    return is_surface ? 5 / (M_PI * 140) : 0.5e-3;
}

/// Peaks are sought so far (s) around their times.
constexpr double kReach = 0.01;

/// The rows near which all others are below 1 % of their peak where they are heard. Before an
/// impact they count as much as after it, because backwards they sound before it.
std::vector<HeardRow> lone(const std::vector<HeardRow>& rows) {
    std::vector<HeardRow> result;
    for (const HeardRow& row : rows) {
        double others = 0;
        for (const HeardRow& other : rows) {
            const double apart = std::max(std::abs(other.peak_time - row.peak_time) - kReach, 0.0);
            others += other.peak * std::exp(-apart * other.time_factor / decay_of(other));
        }
        if (others - row.peak < 0.01 * row.peak) {
            result.push_back(row);
        }
    }
    return result;
}

TEST_F(SoundImpacts, LoneImpactsOfABreak_PeakAtTheirTimes) {
    // The noise of balls that roll moves the peaks of quiet impacts.
    listen(example("nine_ball_break"), "b",
           joined(plain("100 Pa"), {"--set", "sound.mix.rolling=-100 dB"}));
    const WavSamples samples = wav("b");
    ASSERT_EQ(samples.left.size(), 480'000U);
    EXPECT_EQ(samples.left, samples.right);
    const std::vector<HeardRow> rows = lone(heard("b"));
    EXPECT_GT(rows.size(), 15U);
    std::set<std::string> cameras;
    for (const HeardRow& row : rows) {
        cameras.insert(row.camera);
        const std::string what =
            fmt::format("{} {} at {} s, {} Pa", row.a, row.b, row.film_time, row.peak);
        const std::int64_t expected = sample_of(row.peak_time);
        const std::int64_t reach = sample_of(kReach);
        const std::size_t peak = peak_index(samples.left, expected - reach, expected + reach);
        // A cushion's peak is flat, so that in slow motion a thousandth of its pressure moves it.
        EXPECT_NEAR(static_cast<double>(peak) / kSampleRate, row.peak_time,
                    1e-4 / (row.b == "cushion" ? row.time_factor : 1))
            << what;
        EXPECT_NEAR(std::abs(samples.left[peak]) / 0x1p23 * 100, row.peak, 0.03 * row.peak) << what;
    }
    EXPECT_EQ(cameras, (std::set<std::string>{"break", "slow", "rewind"}));
}

TEST_F(SoundImpacts, Clack_HasThePressureOfTheExactForce) {
    // 1 m from the contact, at 60 degrees to the line of centres, without the bed. The expected
    // pressures are those of Hertz's equation of motion, m x'' = -k x^(3/2) with the area
    // m (1 + e) v / 2, integrated in steps of 50 ns by Runge and Kutta's method and convolved with
    // the response of accelerated spheres (Koss & Alfredson, J. Sound Vib. 27, 1973). carom's sum
    // of sines is an approximation of that force, within 0.8 % of its peak.
    struct Case {
        double speed, pressure;  // m/s, Pa
    };
    for (const Case& one : {Case{1, 0.62453}, Case{5, 5.95157}}) {
        write_text(path("clack.yaml"), carom::testing::clack_shot(one.speed));
        listen("clack.yaml", "clack", joined(plain(), {"--set", "sound.bed=0"}));
        const std::vector<HeardRow> rows = heard("clack");
        ASSERT_EQ(rows.size(), 1U);
        EXPECT_NEAR(rows[0].peak, one.pressure, 2e-3 * one.pressure);
        const WavSamples samples = wav("clack");
        const std::size_t peak = peak_index(samples.left, 0, 24'000);
        EXPECT_NEAR(static_cast<double>(peak), rows[0].peak_time * kSampleRate, 1);
        // Between the samples it is higher.
        sound::TruePeakMeter meter;
        meter.add(in_full_scale(samples.left));
        EXPECT_NEAR(20 * meter.peak(), one.pressure, 5e-3 * one.pressure);
    }
}

/// The envelope of the high frequencies in [from, to) s, without its mean, under Hann's window.
std::vector<double> envelope(const std::vector<double>& samples, double from, double to) {
    constexpr std::size_t kSmoothed = 48;  // samples, 1 ms
    const auto first = static_cast<std::size_t>(sample_of(from));
    const auto last = static_cast<std::size_t>(sample_of(to));
    std::vector<double> result;
    for (std::size_t n = first; n < last; ++n) {
        double power = 0;
        for (std::size_t k = 0; k < kSmoothed; ++k) {
            const double slope = samples[n - k] - samples[n - k - 1];
            power += slope * slope;
        }
        result.push_back(std::sqrt(power));
    }
    const auto size = static_cast<double>(result.size());
    const double mean = std::accumulate(result.begin(), result.end(), 0.0) / size;
    for (std::size_t n = 0; n < result.size(); ++n) {
        const double window = 0.5 - 0.5 * std::cos(2 * M_PI * static_cast<double>(n) / size);
        result[n] = (result[n] - mean) * window;
    }
    return result;
}

/// How many pairs of tiles touch each other for the first time per second of film in [from, to).
double first_contacts_per_second(const std::vector<HeardRow>& rows, double from, double to) {
    std::set<std::string> touched;
    std::vector<double> times;
    for (const HeardRow& row : rows) {
        if (row.a.starts_with("tile") && row.b.starts_with("tile") &&
            touched.insert(std::min(row.a, row.b) + std::max(row.a, row.b)).second &&
            row.film_time >= from && row.film_time < to) {
            times.push_back(row.film_time);
        }
    }
    return static_cast<double>(times.size() - 1) / (times.back() - times.front());
}

// As Larham (2013, arXiv 1302.3311) measures the speed of real dominoes, by a microphone.
TEST_F(SoundImpacts, DominoRun_IsHeardAtTheRateOfItsContacts) {
    write_text(path("camera.yaml"), R"(cameras:
  - name: seat
    video: [0 s, 2 s]
    scene: [0.3 s, 2.3 s]
    position: [0.3, 1.5, 0.6]
    target: [0.8, 0.35, 0]
    fov: 60 deg
)");
    listen(example("domino_run"), "run", joined(plain(), {"--camera", "camera.yaml"}));
    const std::vector<double> samples = in_full_scale(wav("run").left);
    const std::vector<HeardRow> rows = heard("run");
    for (const auto& [from, to] : {std::pair{0.92, 1.14}, {1.1, 1.32}, {1.3, 1.6}}) {
        const double expected = first_contacts_per_second(rows, from, to);
        EXPECT_GT(expected, 30);
        EXPECT_LT(expected, 40);
        EXPECT_NEAR(spectral_peak(envelope(samples, from, to), 20, 60), expected, 0.04 * expected)
            << from;
    }
}

}  // namespace
}  // namespace carom::cli
