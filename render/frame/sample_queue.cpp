#include "render/frame/sample_queue.h"

#include <utility>

namespace carom::render {

SampleQueue::SampleQueue(const Integrator& integrator, float pixel_spread, std::size_t size,
                         bool counts_objects, std::stop_token stop, RenderStatistics& count)
    : integrator_(integrator),
      pixel_spread_(pixel_spread),
      size_(size),
      counts_objects_(counts_objects),
      stop_(std::move(stop)),
      count_(count),
      workspace_(integrator.make_workspace()),
      results_(size) {
    tasks_.reserve(size);
    pixels_.reserve(size);
}

void SampleQueue::ask(const CameraTask& task, PixelSums& sums, int group) {
    tasks_.push_back(task);
    pixels_.push_back({&sums, group});
    if (tasks_.size() == size_) {
        flush();
    }
}

void SampleQueue::flush() {
    if (!stop_.stop_requested()) {
        integrator_.samples(tasks_, pixel_spread_, results_, workspace_.get(), count_);
        for (std::size_t i = 0; i < tasks_.size(); ++i) {
            pixels_[i].sums->add(results_[i], pixels_[i].group);
            if (counts_objects_) {
                pixels_[i].sums->count_object(results_[i].object);
            }
        }
    }
    tasks_.clear();
    pixels_.clear();
}

}  // namespace carom::render
