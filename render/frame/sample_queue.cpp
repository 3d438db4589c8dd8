#include "render/frame/sample_queue.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/assert.h"

namespace carom::render {

SampleQueue::SampleQueue(const Setting& setting, std::stop_token stop, RenderStatistics& count)
    : setting_(setting),
      stop_(std::move(stop)),
      count_(count),
      workspace_(setting.workspaces),
      batch_(std::make_unique<CameraBatch>()),
      results_(kSize) {
    CAROM_ASSERT(setting.traced_at_once > 0);
    tasks_.reserve(kSize);
    pixels_.reserve(kSize);
}

void SampleQueue::add(const SampleStream& stream, const SampleIndex& index, PixelSums& sums) {
    const std::size_t i = tasks_.size();
    batch_->x[i] = index.x;
    batch_->y[i] = index.y;
    batch_->pixel_hash[i] = static_cast<std::int32_t>(stream.pixel_hash());
    batch_->reversed_sample[i] = static_cast<std::int32_t>(stream.reversed_sample());
    tasks_.push_back({Ray{}, stream, index});
    pixels_.push_back(&sums);
    if (tasks_.size() == kSize) {
        flush();
    }
}

std::size_t SampleQueue::trace() {
    if (stop_.stop_requested()) {
        return 0;
    }
    batch_->count = static_cast<int>(tasks_.size());
    make_rays(setting_.camera, setting_.fixings, *batch_);
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
        tasks_[i].ray = batch_->ray(static_cast<int>(i));
    }
    for (std::size_t from = 0; from < tasks_.size(); from += setting_.traced_at_once) {
        if (stop_.stop_requested()) {
            return from;
        }
        const std::size_t size = std::min(setting_.traced_at_once, tasks_.size() - from);
        setting_.integrator.samples(std::span(tasks_).subspan(from, size), setting_.pixel_spread,
                                    std::span(results_).subspan(from, size), workspace_.get(),
                                    count_);
    }
    return tasks_.size();
}

void SampleQueue::flush() {
    const std::size_t traced = trace();
    for (std::size_t i = 0; i < traced; ++i) {
        if (setting_.keeps_halves) {
            pixels_[i]->add_to_half(results_[i]);
        }
        pixels_[i]->add(results_[i]);
        if (setting_.counts_objects) {
            pixels_[i]->count_object(results_[i].object);
        }
    }
    tasks_.clear();
    pixels_.clear();
}

}  // namespace carom::render
