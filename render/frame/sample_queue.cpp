#include "render/frame/sample_queue.h"

#include <limits>
#include <span>
#include <utility>

#include "core/assert.h"

namespace carom::render {
namespace {

/// Whether all light is finite and not negative, and the normal finite. Without branches, since it
/// asks of every sample.
bool is_usable(const RadianceSample& sample) {
    const auto is_positive = [](const V3f& v) { return (v.x >= 0) & (v.y >= 0) & (v.z >= 0); };
    const V3f sum = sample.radiance + sample.light + sample.albedo + sample.mirrored;
    const float size = sum.x + sum.y + sum.z + sample.normal.length2();
    return is_positive(sample.radiance) & is_positive(sample.light) & is_positive(sample.albedo) &
           is_positive(sample.mirrored) & (size < std::numeric_limits<float>::infinity());
}

}  // namespace

SampleQueue::SampleQueue(const Setting& setting, std::stop_token stop, RenderStatistics& count)
    : setting_(setting),
      stop_(std::move(stop)),
      count_(count),
      workspace_(setting.workspaces),
      results_(static_cast<std::size_t>(batch_.capacity)) {
    CAROM_ASSERT(setting.traced_at_once > 0);
    pixels_.reserve(results_.size());
}

void SampleQueue::add(const SampleStream& stream, const SampleIndex& index, TileSums& sums,
                      std::size_t pixel) {
    batch_.add(stream, index);
    pixels_.emplace_back(&sums, pixel);
    if (batch_.count == batch_.capacity) {
        flush();
    }
}

int SampleQueue::trace() {
    if (stop_.stop_requested()) {
        return 0;
    }
    make_rays(setting_.camera, setting_.fixings, batch_);
    const CameraRun all = CameraRun::all(batch_);
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
    if (setting_.camera.has_weights()) {
        for (std::size_t i = 0; i < traced; ++i) {
            results_[i].weigh(batch_.weight[i]);
        }
    }
    for (std::size_t i = 0; i < traced; ++i) {
        if (!is_usable(results_[i])) {
            const SampleIndex index = CameraRun::all(batch_).index(static_cast<int>(i));
            count_.add_unusable(1, {index.x, index.y});
            results_[i] = {};
        }
    }
    for (std::size_t first = 0, last = 0; first < traced; first = last) {
        while (last < traced && pixels_[last] == pixels_[first]) {
            ++last;
        }
        pixels_[first].first->add(pixels_[first].second,
                                  std::span(results_).subspan(first, last - first));
    }
    batch_.count = 0;
    pixels_.clear();
}

}  // namespace carom::render
