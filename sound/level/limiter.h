// Keeps a stereo signal below a true peak.
#pragma once

#include <array>
#include <cstddef>
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

    /// The lowest factor so far, at most 1.
    [[nodiscard]] double lowest_factor() const { return lowest_; }

  private:
    double factor_for(double peak);

    double ceiling_;
    PeakInterpolator left_peak_, right_peak_;
    std::array<double, kDelay> left_{}, right_{};  // samples on their way, in rings
    std::size_t oldest_ = 0;
    // The factors that the latest samples need, and those after the release, in rings.
    std::array<double, kLookAhead + 1> needed_{}, released_{};
    std::size_t at_ = 0;
    double lowest_ = 1;
};

}  // namespace carom::sound
