#include "render/frame/adaptive_progress.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <utility>

#include "render/frame/sample_plan.h"

namespace carom::render {
namespace {

constexpr int kEstimates = 16;  // during the first samples

/// The part of the error that the denoiser leaves with few samples (docs/denoising.md).
constexpr float kLeftByDenoiser = 0.13F;

/// Close to the golden section of `tiles` and coprime to it, so that its multiples visit every tile
/// once and are evenly spread.
int spreading_stride(int tiles) {
    int stride = std::max(1, static_cast<int>(std::lround(0.618 * tiles)));
    while (std::gcd(stride, tiles) != 1) {
        ++stride;
    }
    return stride;
}

}  // namespace

AdaptiveProgress::AdaptiveProgress(const ProgressCallback& callback, const RenderSettings& settings,
                                   int tiles)
    : callback_(callback),
      settings_(settings),
      tiles_(tiles),
      stride_(spreading_stride(tiles)),
      begun_(static_cast<std::size_t>(tiles)) {}

int AdaptiveProgress::nth_tile(int n) const {
    return static_cast<int>(std::int64_t{n} * stride_ % tiles_);
}

void AdaptiveProgress::first_samples_done(int tile, const std::vector<float>& errors,
                                          double seconds) {
    const std::lock_guard<std::mutex> lock(mutex_);
    begun_[static_cast<std::size_t>(tile)] = {seconds, errors};
    work_ += seconds;
    begun_count_ += 1;
    const int between = std::max(1, tiles_ / kEstimates);
    if (begun_count_ % between == 0) {
        ratio_ = expected_ratio();
    }
    if (begun_count_ >= between) {
        report(static_cast<double>(begun_count_) / tiles_ / (1 + ratio_));
    }
}

/// From a plan for the tiles that have their first samples.
double AdaptiveProgress::expected_ratio() const {
    MeasuredError error;
    for (const BegunTile& tile : begun_) {
        error.by_pixel.insert(error.by_pixel.end(), tile.errors.begin(), tile.errors.end());
    }
    for (float& value : error.by_pixel) {
        value *= settings_.for_denoiser ? kLeftByDenoiser : 1;
        error.mean += static_cast<double>(value) / static_cast<double>(error.by_pixel.size());
    }
    const std::vector<int> expected =
        next_round(std::vector<int>(error.by_pixel.size(), settings_.samples), error, settings_)
            .expected;
    double first = 0;
    double further = 0;
    auto samples = expected.begin();
    for (const BegunTile& tile : begun_) {
        const auto end = samples + std::ssize(tile.errors);
        const double sum = std::accumulate(samples, end, 0.0);
        samples = end;
        first += tile.seconds;
        if (!tile.errors.empty()) {
            const double mean = sum / static_cast<double>(tile.errors.size());
            further += tile.seconds * (mean / settings_.samples - 1);
        }
    }
    return first > 0 ? further / first : 0;
}

void AdaptiveProgress::begin_round(std::vector<double> now, const std::vector<double>& in_all) {
    const std::lock_guard<std::mutex> lock(mutex_);
    round_ = std::move(now);
    all_work_ = work_;
    for (std::size_t tile = 0; tile < begun_.size(); ++tile) {
        all_work_ += begun_[tile].seconds * in_all[tile];
    }
    report(all_work_ > 0 ? work_ / all_work_ : 0);
}

void AdaptiveProgress::tile_done(int tile) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto index = static_cast<std::size_t>(tile);
    work_ += begun_[index].seconds * round_[index];
    report(work_ / std::max(all_work_, work_));
}

/// A fraction that was overestimated stays until the work has caught up.
void AdaptiveProgress::report(double fraction) {
    fraction_ = std::clamp(fraction, fraction_, 1.0);
    if (callback_) {
        callback_(fraction_);
    }
}

}  // namespace carom::render
