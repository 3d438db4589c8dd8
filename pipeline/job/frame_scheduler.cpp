#include "pipeline/job/frame_scheduler.h"

#include <utility>

#include <fmt/core.h>

#include "core/error.h"

namespace carom::pipeline {
namespace {

constexpr std::chrono::milliseconds kClaimPollInterval{50};
constexpr int kMaxRepairs = 3;

}  // namespace

void FrameScheduler::run(const std::stop_token& stop) {
    std::size_t next = 0;
    while (true) {
        if (stop.stop_requested()) {
            throw Stopped();
        }
        if (const std::optional<std::size_t> broken = queue_.take_request()) {
            repair(*broken, stop);
        } else if (retry_deferred(stop)) {
            continue;
        } else if (next < plan_.pictures.size()) {
            if (!try_render(next, stop)) {
                deferred_.push_back(next);
            }
            ++next;
        } else if (!deferred_.empty()) {
            wait_for_others(stop);
        } else if (queue_.reader_is_done()) {
            return;
        } else {
            queue_.wait_for_reader(stop);
        }
    }
}

void FrameScheduler::wait_for_others(const std::stop_token& stop) {
    if (const std::optional<std::string> waited = wait_.due()) {
        const FilmPlan::Picture& picture = plan_.pictures[deferred_.front()];
        observer_.warning(
            renderer_.waiting_text(picture, picture.frame, deferred_.size() - 1, *waited));
    }
    queue_.wait_for_request(kClaimPollInterval, stop);
}

bool FrameScheduler::try_render(std::size_t picture, const std::stop_token& stop) {
    WorkContext context;
    context.stop = stop;
    context.progress = [this](double fraction) {
        constexpr double kRendering = 0.999;  // the rest is storing
        observer_.render_progress((static_cast<double>(reported_frames_) + fraction * kRendering) /
                                  static_cast<double>(plan_.picture_of.size()));
    };
    CachedRender result = renderer_.render(plan_.pictures[picture], context);
    if (result.origin == RenderOrigin::claimed_elsewhere) {
        return false;
    }
    wait_.end();
    if (result.origin == RenderOrigin::rendered && !is_rendered_[picture]) {
        is_rendered_[picture] = true;
        ++rendered_;
    }
    counts_ += result.counts;
    observer_.check(result.counts, plan_.pictures[picture].frame);
    report(picture, result);
    queue_.mark_ready(picture, std::move(result.film));
    if (on_stored_ && result.origin == RenderOrigin::rendered) {
        on_stored_(picture);
    }
    return true;
}

bool FrameScheduler::retry_deferred(const std::stop_token& stop) {
    for (auto it = deferred_.begin(); it != deferred_.end(); ++it) {
        if (try_render(*it, stop)) {
            deferred_.erase(it);
            return true;
        }
    }
    return false;
}

void FrameScheduler::repair(std::size_t picture, const std::stop_token& stop) {
    const FilmPlan::Picture& broken = plan_.pictures[picture];
    ++repairs_[picture];
    if (repairs_[picture] > kMaxRepairs) {
        throw Error(fmt::format(
            "frame {} was rendered several times, but cannot be read back from the cache",
            broken.frame));
    }
    if (!try_render(picture, stop)) {
        deferred_.push_front(picture);
    }
}

// Every frame of the film is reported once, even if its picture is rendered again later.
void FrameScheduler::report(std::size_t picture, const CachedRender& result) {
    if (is_reported_[picture]) {
        return;
    }
    is_reported_[picture] = true;
    bool from_store = result.origin == RenderOrigin::stored;
    for (const std::int64_t frame : plan_.pictures[picture].frames) {
        observer_.frame(frame, from_store, from_store ? 0 : result.seconds,
                        from_store ? 0 : result.rays());
        from_store = true;  // for the other frames the picture is stored now
        ++reported_frames_;
    }
    observer_.render_progress(static_cast<double>(reported_frames_) /
                              static_cast<double>(plan_.picture_of.size()));
}

}  // namespace carom::pipeline
