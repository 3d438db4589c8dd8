#include "sound/level/true_peak.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace carom::sound {
namespace {

using Taps = std::array<double, PeakInterpolator::kTaps>;

/// A bound of the sum of absolute taps of every phase: 2.0 at the middle between two samples.
constexpr double kMaxGain = 2.5;

/// The factors of the samples, the oldest one first, for the value at `fraction` of the way from
/// the sample of index kDelay - 1 to the next one.
Taps taps_at(double fraction) {
    Taps taps{};
    double sum = 0;
    for (std::size_t i = 0; i < taps.size(); ++i) {
        const double distance =
            static_cast<double>(i) - static_cast<double>(PeakInterpolator::kDelay - 1) - fraction;
        const double window = cosine(std::numbers::pi * distance / PeakInterpolator::kTaps);
        const double angle = std::numbers::pi * distance;
        taps[i] = sine(angle) / angle * window * window;
        sum += taps[i];
    }
    for (double& tap : taps) {
        tap /= sum;
    }
    return taps;
}

const std::array<Taps, 3>& phases() {
    static const std::array<Taps, 3> kPhases{taps_at(0.25), taps_at(0.5), taps_at(0.75)};
    return kPhases;
}

}  // namespace

double PeakInterpolator::highest() const {
    const double* oldest = window_.data() + next_;
    double most = std::abs(oldest[kDelay - 1]);
    for (const Taps& taps : phases()) {
        double value = 0;
        for (std::size_t i = 0; i < kTaps; ++i) {
            value += taps[i] * oldest[i];
        }
        most = std::max(most, std::abs(value));
    }
    return most;
}

double PeakInterpolator::push_above(double sample, double least) {
    window_[next_] = window_[next_ + kTaps] = sample;
    next_ = next_ + 1 == kTaps ? 0 : next_ + 1;
    if (std::abs(sample) * kMaxGain > least) {
        loud_for_ = kTaps;
    }
    if (loud_for_ == 0) {
        return 0;
    }
    --loud_for_;
    return highest();
}

void TruePeakMeter::add(std::span<const double> samples) {
    for (const double sample : samples) {
        peak_ = std::max(peak_, interpolator_.push_above(sample, peak_));
    }
}

double TruePeakMeter::peak() const {
    PeakInterpolator rest = interpolator_;
    double peak = peak_;
    for (std::size_t i = 0; i < PeakInterpolator::kTaps; ++i) {
        peak = std::max(peak, rest.push_above(0, peak));
    }
    return peak;
}

}  // namespace carom::sound
