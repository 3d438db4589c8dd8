#include "render/frame/adaptive_progress.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "render/frame/sample_plan.h"

namespace carom::render {
namespace {

constexpr int kEstimates = 16;  // during the first samples

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

void AdaptiveProgress::first_samples_done(int tile, const std::vector<double>& deviations,
                                          double seconds) {
    const std::lock_guard<std::mutex> lock(mutex_);
    begun_[static_cast<std::size_t>(tile)] = {seconds, deviations};
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
    std::vector<double> all;
    for (const BegunTile& tile : begun_) {
        all.insert(all.end(), tile.deviations.begin(), tile.deviations.end());
    }
    const double scale = samples_per_deviation(all, settings_);
    double first = 0;
    double further = 0;
    for (const BegunTile& tile : begun_) {
        double samples = 0;
        for (const double deviation : tile.deviations) {
            samples += wanted_samples(deviation, scale, settings_);
        }
        const double mean =
            samples / static_cast<double>(std::max<std::size_t>(1, tile.deviations.size()));
        first += tile.seconds;
        further += tile.seconds * std::max(0.0, mean / settings_.samples - 1);
    }
    return first > 0 ? further / first : 0;
}

void AdaptiveProgress::set_plan(std::vector<double> further) {
    const std::lock_guard<std::mutex> lock(mutex_);
    further_ = std::move(further);
    all_work_ = work_;
    for (std::size_t tile = 0; tile < begun_.size(); ++tile) {
        all_work_ += begun_[tile].seconds * further_[tile];
    }
    report(all_work_ > 0 ? work_ / all_work_ : 0);
}

void AdaptiveProgress::tile_done(int tile) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto index = static_cast<std::size_t>(tile);
    work_ += begun_[index].seconds * further_[index];
    done_count_ += 1;
    report(done_count_ == tiles_ ? 1 : work_ / std::max(all_work_, work_));
}

/// A fraction that was overestimated stays until the work has caught up.
void AdaptiveProgress::report(double fraction) {
    fraction_ = std::clamp(fraction, fraction_, 1.0);
    if (callback_) {
        callback_(fraction_);
    }
}

}  // namespace carom::render
