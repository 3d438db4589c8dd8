#include "render/frame/sample_queue.h"

#include <utility>

#include "core/assert.h"
#include "render/geometry/validity.h"

namespace carom::render {
namespace {

bool is_usable(const RadianceSample& sample) {
    return is_light(sample.radiance) && is_light(sample.light) && is_light(sample.albedo) &&
           is_light(sample.mirrored) && is_finite(sample.normal);
}

}  // namespace

SampleQueue::SampleQueue(const Setting& setting, std::stop_token stop, RenderStatistics& count)
    : setting_(setting),
      stop_(std::move(stop)),
      count_(count),
      workspace_(setting.workspaces),
      batch_(std::make_unique<CameraBatch>()),
      results_(kSize) {
    CAROM_ASSERT(setting.traced_at_once > 0);
    pixels_.reserve(kSize);
}

void SampleQueue::add(const SampleStream& stream, const SampleIndex& index, TileSums& sums,
                      std::size_t pixel) {
    batch_->add(stream, index);
    pixels_.emplace_back(&sums, pixel);
    if (batch_->count == kSize) {
        flush();
    }
}

int SampleQueue::trace() {
    if (stop_.stop_requested()) {
        return 0;
    }
    make_rays(setting_.camera, setting_.fixings, *batch_);
    const CameraRun all = CameraRun::all(*batch_);
    for (int from = 0; from < all.count; from += setting_.traced_at_once) {
        if (stop_.stop_requested()) {
            return from;
        }
        setting_.integrator.samples(all.part(from, setting_.traced_at_once), setting_.pixel_spread,
                                    results_.data() + from, workspace_.get(), count_);
    }
    return all.count;
}

void SampleQueue::flush() {
    const auto traced = static_cast<std::size_t>(trace());
    for (std::size_t i = 0; i < traced; ++i) {
        if (!is_usable(results_[i])) {
            const SampleIndex index = CameraRun::all(*batch_).index(static_cast<int>(i));
            count_.add_unusable(1, {index.x, index.y});
            results_[i] = {};
        }
        pixels_[i].first->add(pixels_[i].second, results_[i]);
    }
    batch_->count = 0;
    pixels_.clear();
}

}  // namespace carom::render
