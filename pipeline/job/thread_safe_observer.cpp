#include "pipeline/job/thread_safe_observer.h"

#include <utility>

#include <fmt/core.h>

namespace carom::pipeline {

void ThreadSafeObserver::report_progress(std::string_view stage, double fraction) {
    if (observer_.on_progress) {
        observer_.on_progress(stage, fraction);
    }
}

void ThreadSafeObserver::render_progress(double fraction) {
    const std::scoped_lock lock(mutex_);
    if (fraction > render_fraction_) {
        render_fraction_ = fraction;
        report_progress("render", fraction);
        if (fraction >= 1 && encode_fraction_ > 0) {
            report_progress("encode", encode_fraction_);
        }
    }
}

void ThreadSafeObserver::encode_progress(double fraction) {
    const std::scoped_lock lock(mutex_);
    if (fraction > encode_fraction_) {
        encode_fraction_ = fraction;
        if (render_fraction_ >= 1) {
            report_progress("encode", fraction);
        }
    }
}

void ThreadSafeObserver::warning(const std::string& message) {
    const std::scoped_lock lock(mutex_);
    if (observer_.on_warning) {
        observer_.on_warning(message);
    }
}

void ThreadSafeObserver::check(const render::RenderStatistics& counts, std::int64_t frame) {
    {
        const std::scoped_lock lock(mutex_);
        if (counts.unusable_samples == 0 || std::exchange(has_warned_of_samples_, true)) {
            return;
        }
    }
    const auto [x, y] = counts.unusable_pixel;
    warning(fmt::format(
        "frame {}: {} of its samples, the first at pixel ({}, {}), {} negative or not "
        "finite, which is a fault of carom; they count as black",
        frame, counts.unusable_samples, x, y, counts.unusable_samples == 1 ? "was" : "were"));
}

void ThreadSafeObserver::frame(std::int64_t number, bool from_store, double seconds,
                               std::uint64_t rays) {
    const std::scoped_lock lock(mutex_);
    if (observer_.on_frame) {
        observer_.on_frame(number, from_store, seconds, rays);
    }
}

}  // namespace carom::pipeline
