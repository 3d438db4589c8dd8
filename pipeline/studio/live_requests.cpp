#include "pipeline/studio/live_requests.h"

#include <utility>

namespace carom::studio {

void LiveRequests::offer(TextsOfVersion texts) {
    const std::lock_guard lock(mutex_);
    newest_ = texts;
    waiting_ = LiveRequest{std::move(texts), false};
    deferred_ = false;
    bake_.stop_for_newer();
    wake_.notify_one();
}

void LiveRequests::set_dragging(bool on) {
    const std::lock_guard lock(mutex_);
    dragging_ = on;
    if (!on && deferred_ && !waiting_) {
        waiting_ = LiveRequest{newest_, false};
        deferred_ = false;
        wake_.notify_one();
    }
}

void LiveRequests::simulate() {
    const std::lock_guard lock(mutex_);
    if (!newest_.shot.empty()) {
        waiting_ = LiveRequest{newest_, true};
        wake_.notify_one();
    }
}

std::optional<LiveRequest> LiveRequests::next(const std::stop_token& end) {
    std::unique_lock lock(mutex_);
    if (!wake_.wait(lock, end, [&] { return waiting_.has_value(); }) || bake_.has_ended()) {
        return std::nullopt;
    }
    return std::exchange(waiting_, {});
}

bool LiveRequests::has_newer() {
    const std::lock_guard lock(mutex_);
    return waiting_.has_value() || bake_.has_ended();
}

std::optional<TextsOfVersion> LiveRequests::other_than(std::int64_t v) {
    const std::lock_guard lock(mutex_);
    return waiting_ && waiting_->texts.v != v ? std::optional(waiting_->texts) : std::nullopt;
}

bool LiveRequests::defer(bool has_motion) {
    const std::lock_guard lock(mutex_);
    deferred_ = dragging_ && bake_.was_slow() && has_motion;
    return deferred_;
}

}  // namespace carom::studio
