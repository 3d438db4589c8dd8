#include "pipeline/job/picture_board.h"

#include <utility>

#include "core/error.h"

namespace carom::pipeline {

void PictureBoard::mark_ready(std::size_t picture, std::optional<render::Film> film) {
    {
        const std::scoped_lock lock(mutex_);
        is_ready_[picture] = true;
        if (awaited_ == picture) {
            film_ = std::move(film);
        }
    }
    changed_.notify_all();
}

std::optional<std::size_t> PictureBoard::take_request() {
    const std::scoped_lock lock(mutex_);
    if (requests_.empty()) {
        return std::nullopt;
    }
    const std::size_t picture = requests_.front();
    requests_.pop_front();
    return picture;
}

bool PictureBoard::reader_is_done() {
    const std::scoped_lock lock(mutex_);
    return reader_is_done_;
}

void PictureBoard::wait_for_request(std::chrono::milliseconds longest,
                                    const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, stop, longest, [this] { return !requests_.empty(); });
}

void PictureBoard::wait_for_reader(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, stop, [this] { return !requests_.empty() || reader_is_done_; });
}

bool PictureBoard::wait_until_ready(std::size_t picture, const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    return changed_.wait(lock, stop, [this, picture] { return is_ready_[picture]; });
}

std::optional<render::Film> PictureBoard::receive(std::size_t picture,
                                                  const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    awaited_ = picture;
    const bool is_ready = changed_.wait(lock, stop, [this, picture] { return is_ready_[picture]; });
    awaited_.reset();
    if (!is_ready || stop.stop_requested()) {
        throw Stopped();
    }
    return std::exchange(film_, std::nullopt);
}

void PictureBoard::request_again(std::size_t picture) {
    {
        const std::scoped_lock lock(mutex_);
        is_ready_[picture] = false;
        requests_.push_back(picture);
    }
    changed_.notify_all();
}

void PictureBoard::reader_done() {
    {
        const std::scoped_lock lock(mutex_);
        reader_is_done_ = true;
    }
    changed_.notify_all();
}

}  // namespace carom::pipeline
