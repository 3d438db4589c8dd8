#include "pipeline/studio/live_requests.h"

#include <utility>

namespace carom::studio {

namespace {

constexpr std::chrono::milliseconds kPause{500};  // between slow simulations during a drag

}  // namespace

void LiveRequests::offer(TextsOfVersion texts) {
    const std::lock_guard lock(mutex_);
    newest_ = texts;
    waiting_ = LiveRequest{std::move(texts), false};
    deferred_.reset();
    wake_.notify_one();
}

void LiveRequests::set_dragging(bool on) {
    const std::lock_guard lock(mutex_);
    dragging_ = on;
    if (!on && deferred_ && !waiting_) {
        waiting_ = LiveRequest{newest_, false};
        deferred_.reset();
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
    const auto is_wanted = [&] { return waiting_.has_value(); };
    while (deferred_ && !is_wanted() && !end.stop_requested()) {
        const LiveBake::Clock::time_point until = *deferred_;
        if (!wake_.wait_until(lock, end, until, [&] { return is_wanted() || !deferred_; }) &&
            !end.stop_requested()) {
            waiting_ = LiveRequest{newest_, false};
            deferred_.reset();
        }
    }
    if (!wake_.wait(lock, end, is_wanted) || bake_.has_ended()) {
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
    deferred_.reset();
    if (dragging_ && bake_.was_slow() && has_motion) {
        const LiveBake::Clock::time_point next = bake_.last_end() + kPause;
        if (LiveBake::Clock::now() < next) {
            deferred_ = next;
        }
    }
    return deferred_.has_value();
}

}  // namespace carom::studio
