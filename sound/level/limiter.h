// Keeps a stereo signal below a true peak.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "sound/level/true_peak.h"

namespace carom::sound {

/// Turns both channels down alike before each peak that would be too high, within 1.5 ms, and up
/// again afterwards, by 63 % of the way in 60 ms (tuned). The gain never rises while a peak is
/// ahead, and is an average over those 1.5 ms, so it has no steps.
class Limiter {
  public:
    /// `ceiling`: the true peak that the result does not exceed, > 0.
    explicit Limiter(double ceiling);

    /// Samples of look-ahead: 1.5 ms.
    static constexpr std::size_t kLookAhead = 72;
    /// Samples by which the result is later than what comes in.
    static constexpr std::size_t kDelay = kLookAhead + PeakInterpolator::kDelay;

    /// Replaces the samples of both channels, of the same size, by the result, whose first kDelay
    /// samples are silent. In order of time, in blocks of any size.
    void run(std::span<double> left, std::span<double> right);

    /// The same, but turned down as the key needs it, of which `left` and `right` are a part. All
    /// have the same size.
    void run(std::span<const double> key_left, std::span<const double> key_right,
             std::span<double> left, std::span<double> right);

    /// The lowest factor so far, at most 1.
    [[nodiscard]] double lowest_factor() const { return lowest_; }

  private:
    static constexpr std::size_t kWindow = kLookAhead + 1;

    double factor_for(double peak);
    double least_of_window(double needed);

    double ceiling_;
    PeakInterpolator left_peak_, right_peak_;
    std::array<double, kDelay> left_{}, right_{};  // samples on their way, in rings
    std::size_t oldest_ = 0;
    // Of the factors that the latest kWindow samples need, those that no later one undercuts, which
    // rise from the first to the last: a ring of them and of the samples' numbers.
    std::array<double, kWindow> least_{};
    std::array<std::int64_t, kWindow> least_at_{};
    std::size_t first_least_ = 0, least_count_ = 0;
    double latest_ = 1;  // factor after the release
    std::array<std::int64_t, kWindow>
        window_{};             // the latest of those, in units of 2^-40, in a ring
    std::int64_t sum_ = 0;     // of the window
    std::size_t at_ = 0;       // the latest in the window
    std::int64_t number_ = 0;  // of samples so far
    double lowest_ = 1;
};

}  // namespace carom::sound
