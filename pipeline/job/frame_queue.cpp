#include "pipeline/job/frame_queue.h"

#include <utility>

#include "core/error.h"

namespace carom::pipeline {

void FrameQueue::mark_ready(std::size_t picture, std::optional<render::Film> film) {
    {
        const std::scoped_lock lock(mutex_);
        is_ready_[picture] = true;
        if (awaited_ == picture) {
            film_ = std::move(film);
        }
    }
    changed_.notify_all();
}

std::optional<std::size_t> FrameQueue::take_request() {
    const std::scoped_lock lock(mutex_);
    if (requests_.empty()) {
        return std::nullopt;
    }
    const std::size_t picture = requests_.front();
    requests_.pop_front();
    return picture;
}

bool FrameQueue::reader_is_done() {
    const std::scoped_lock lock(mutex_);
    return reader_is_done_;
}

void FrameQueue::wait_for_request(std::chrono::milliseconds longest, const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, stop, longest, [this] { return !requests_.empty(); });
}

void FrameQueue::wait_for_reader(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, stop, [this] { return !requests_.empty() || reader_is_done_; });
}

bool FrameQueue::wait_until_ready(std::size_t picture, const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    return changed_.wait(lock, stop, [this, picture] { return is_ready_[picture]; });
}

std::optional<render::Film> FrameQueue::receive(std::size_t picture, const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    awaited_ = picture;
    const bool is_ready = changed_.wait(lock, stop, [this, picture] { return is_ready_[picture]; });
    awaited_.reset();
    if (!is_ready || stop.stop_requested()) {
        throw Stopped();
    }
    return std::exchange(film_, std::nullopt);
}

void FrameQueue::request_again(std::size_t picture) {
    {
        const std::scoped_lock lock(mutex_);
        is_ready_[picture] = false;
        requests_.push_back(picture);
    }
    changed_.notify_all();
}

void FrameQueue::mark_reader_done() {
    {
        const std::scoped_lock lock(mutex_);
        reader_is_done_ = true;
    }
    changed_.notify_all();
}

}  // namespace carom::pipeline
