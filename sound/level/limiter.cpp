#include "sound/level/limiter.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "sound/sound_scene.h"

namespace carom::sound {
namespace {

/// Of the way back to 1, from sample to sample: 63 % in 60 ms.
constexpr double kRecovery = 1 / (0.060 * kSampleRate);

/// The factors change from sample to sample, so a peak between two of them, which is interpolated
/// from many, may be a little higher than its own factor makes it.
constexpr double kMargin = 0.985;

/// Factors are summed as whole numbers, so that the sum of a window never drifts.
constexpr std::int64_t kOne = std::int64_t{1} << 40;

}  // namespace

Limiter::Limiter(double ceiling) : ceiling_(ceiling) {
    CAROM_ASSERT(ceiling > 0);
    window_.fill(kOne);
    sum_ = kOne * static_cast<std::int64_t>(kWindow);
}

/// The least of the factors that the latest kWindow samples need, of which `needed` is the last.
double Limiter::least_of_window(double needed) {
    const auto place = [&](std::size_t i) { return (first_least_ + i) % kWindow; };
    if (least_count_ > 0 &&
        least_at_[first_least_] + static_cast<std::int64_t>(kWindow) <= number_) {
        first_least_ = place(1);
        --least_count_;
    }
    while (least_count_ > 0 && least_[place(least_count_ - 1)] >= needed) {
        --least_count_;
    }
    least_[place(least_count_)] = needed;
    least_at_[place(least_count_)] = number_;
    ++least_count_;
    ++number_;
    return least_[first_least_];
}

/// `peak`: between the sample of this call and the next one. Returns the factor of the sample that
/// is kLookAhead older. With needed[n] = ceiling / peak at the sample n, the factors before release
/// are the minima of needed[n .. n + kLookAhead], and the result is the mean of the last
/// kLookAhead + 1 of those: each of them contains needed[n], so the mean is not above it. The
/// sample after the peak has nearly the same factor, because the recovery is slow.
double Limiter::factor_for(double peak) {
    const double needed = peak > ceiling_ * kMargin ? ceiling_ * kMargin / peak : 1;
    latest_ = std::min(least_of_window(needed), latest_ + (1 - latest_) * kRecovery);
    at_ = at_ + 1 == kWindow ? 0 : at_ + 1;
    const auto latest =
        static_cast<std::int64_t>(std::floor(latest_ * static_cast<double>(kOne) + 0.5));
    sum_ += latest - window_[at_];
    window_[at_] = latest;
    return static_cast<double>(sum_) / static_cast<double>(kOne * kWindow);
}

void Limiter::run(std::span<double> left, std::span<double> right) {
    run(left, right, left, right);
}

void Limiter::run(std::span<const double> key_left, std::span<const double> key_right,
                  std::span<double> left, std::span<double> right) {
    CAROM_ASSERT(left.size() == right.size());
    CAROM_ASSERT(key_left.size() == left.size() && key_right.size() == left.size());
    const double least = ceiling_ * kMargin;
    for (std::size_t n = 0; n < left.size(); ++n) {
        const double peak = std::max(left_peak_.push_above(key_left[n], least),
                                     right_peak_.push_above(key_right[n], least));
        const double factor = factor_for(peak);
        lowest_ = std::min(lowest_, factor);
        std::swap(left[n], left_[oldest_]);
        std::swap(right[n], right_[oldest_]);
        left[n] *= factor;
        right[n] *= factor;
        oldest_ = oldest_ + 1 == kDelay ? 0 : oldest_ + 1;
    }
}

}  // namespace carom::sound
