#include "sound/level/limiter.h"

#include <algorithm>
#include <numeric>

#include "core/assert.h"

namespace carom::sound {
namespace {

/// Of the way back to 1, from sample to sample: 63 % in 60 ms.
constexpr double kRecovery = 1 / (0.060 * 48000);

/// The factors change from sample to sample, so a peak between two of them, which is interpolated
/// from many, may be a little higher than its own factor makes it.
constexpr double kMargin = 0.985;

}  // namespace

Limiter::Limiter(double ceiling) : ceiling_(ceiling) {
    CAROM_ASSERT(ceiling > 0);
    needed_.fill(1);
    released_.fill(1);
}

/// `peak`: between the sample of this call and the next one. Returns the factor of the sample that
/// is kLookAhead older. With needed[n] = ceiling / peak at the sample n, the factors before release
/// are the minima of needed[n .. n + kLookAhead], and the result is the mean of the last
/// kLookAhead + 1 of those: each of them contains needed[n], so the mean is not above it. The
/// sample after the peak has nearly the same factor, because the recovery is slow.
double Limiter::factor_for(double peak) {
    const double latest = released_[at_];
    at_ = at_ + 1 == needed_.size() ? 0 : at_ + 1;
    needed_[at_] = peak > ceiling_ * kMargin ? ceiling_ * kMargin / peak : 1;
    const double least = *std::min_element(needed_.begin(), needed_.end());
    released_[at_] = std::min(least, latest + (1 - latest) * kRecovery);
    const double sum = std::accumulate(released_.begin(), released_.end(), 0.0);
    return sum / static_cast<double>(released_.size());
}

void Limiter::run(std::span<double> left, std::span<double> right) {
    CAROM_ASSERT(left.size() == right.size());
    for (std::size_t n = 0; n < left.size(); ++n) {
        const double peak = std::max(left_peak_.push(left[n]), right_peak_.push(right[n]));
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
