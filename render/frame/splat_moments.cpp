#include "render/frame/splat_moments.h"

namespace carom::render {

void SplatMoments::add(std::size_t pixel, int quarter, float luminance) {
    if (entry_of_[pixel] < 0) {
        entry_of_[pixel] = static_cast<std::int32_t>(entries_.size());
        entries_.push_back({pixel, {}});
    }
    entries_[static_cast<std::size_t>(entry_of_[pixel])].sums[static_cast<std::size_t>(quarter)] +=
        luminance;
}

namespace {

constexpr float kQuarterOverWhole = 8;  // their variances

}  // namespace

void SplatMoments::finish_image(float weight) {
    for (const Entry& entry : entries_) {
        float whole = 0;
        for (const float sum : entry.sums) {
            whole += sum;
        }
        float squares = 0;
        for (const float sum : entry.sums) {
            const float deviation = kQuarters * sum - whole;
            squares += deviation * deviation;
        }
        mean_[entry.pixel] += weight * whole;
        const float of_quarter = squares / (kQuarters - 1);
        variance_[entry.pixel] += weight * weight * of_quarter / kQuarterOverWhole;
        entry_of_[entry.pixel] = -1;
    }
    entries_.clear();
}

}  // namespace carom::render
