#include "pipeline/job/frame_scheduler.h"

#include <utility>

#include <fmt/core.h>

#include "core/error.h"

namespace carom::pipeline {
namespace {

constexpr std::chrono::milliseconds kPollHeld{50};  // how soon another's picture is noticed
constexpr int kMostRepairs = 3;

}  // namespace

void FrameScheduler::run(const std::stop_token& stop) {
    std::size_t next = 0;
    while (true) {
        if (stop.stop_requested()) {
            throw Stopped();
        }
        if (const std::optional<std::size_t> broken = queue_.take_request()) {
            repair(*broken, stop);
        } else if (try_held(stop)) {
            continue;
        } else if (next < plan_.pictures.size()) {
            if (!try_make(next, stop)) {
                held_.push_back(next);
            }
            ++next;
        } else if (!held_.empty()) {
            queue_.wait_for_request(kPollHeld, stop);
        } else if (queue_.reader_is_done()) {
            return;
        } else {
            queue_.wait_for_reader(stop);
        }
    }
}

bool FrameScheduler::try_make(std::size_t picture, const std::stop_token& stop) {
    WorkContext context;
    context.stop = stop;
    context.progress = [this](double fraction) {
        constexpr double kRendering = 0.999;  // storing is the rest
        observer_.render_progress((static_cast<double>(reported_frames_) + fraction * kRendering) /
                                  static_cast<double>(plan_.picture_of.size()));
    };
    CachedRender made = renderer_.make(plan_.pictures[picture], context);
    if (made.origin == RenderOrigin::held) {
        return false;
    }
    if (made.origin == RenderOrigin::rendered && !is_rendered_[picture]) {
        is_rendered_[picture] = true;
        ++rendered_;
    }
    counts_ += made.counts;
    report(picture, made);
    queue_.mark_ready(picture, std::move(made.film));
    if (keeper_ != nullptr && made.origin == RenderOrigin::rendered) {
        keeper_->picture_stored();
    }
    return true;
}

bool FrameScheduler::try_held(const std::stop_token& stop) {
    for (auto it = held_.begin(); it != held_.end(); ++it) {
        if (try_make(*it, stop)) {
            held_.erase(it);
            return true;
        }
    }
    return false;
}

void FrameScheduler::repair(std::size_t picture, const std::stop_token& stop) {
    const FilmPlan::Picture& broken = plan_.pictures[picture];
    ++repairs_[picture];
    if (repairs_[picture] > kMostRepairs) {
        throw Error(
            fmt::format("frame {} was rendered several times, but the cache never holds it whole",
                        broken.frame));
    }
    if (!try_make(picture, stop)) {
        held_.push_front(picture);
    }
}

// Every frame of the film is told of once, also if its picture is made again later.
void FrameScheduler::report(std::size_t picture, const CachedRender& made) {
    if (is_reported_[picture]) {
        return;
    }
    is_reported_[picture] = true;
    bool from_store = made.origin == RenderOrigin::stored;
    for (const std::int64_t frame : plan_.pictures[picture].frames) {
        observer_.frame(frame, from_store, from_store ? 0 : made.seconds,
                        from_store ? 0 : made.rays());
        from_store = true;  // the others show what is there by now
        ++reported_frames_;
    }
    observer_.render_progress(static_cast<double>(reported_frames_) /
                              static_cast<double>(plan_.picture_of.size()));
}

}  // namespace carom::pipeline
