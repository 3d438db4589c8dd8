// The rendering side of a job: sees to it that the store has every picture.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "pipeline/job/cache_keeper.h"
#include "pipeline/job/cached_renderer.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/job/frame_queue.h"
#include "pipeline/job/thread_safe_observer.h"

namespace carom::pipeline {

/// Goes through the pictures in order of first use. One that another process is rendering is left
/// for later; one that the encoder cannot read is made again at once. Refers to its arguments.
class FrameScheduler {
  public:
    /// `keeper`, if there is one, hears of every picture that is stored.
    FrameScheduler(const FilmPlan& plan, CachedRenderer& renderer, FrameQueue& queue,
                   ThreadSafeObserver& observer, CacheKeeper* keeper = nullptr)
        : plan_(plan),
          renderer_(renderer),
          queue_(queue),
          observer_(observer),
          keeper_(keeper),
          is_reported_(plan.pictures.size(), false),
          is_rendered_(plan.pictures.size(), false),
          repairs_(plan.pictures.size(), 0) {}

    /// Returns when the reader of the queue is done. Throws Error, Stopped.
    void run(const std::stop_token& stop);

    /// How many pictures were rendered, not found. One that is rendered a second time, because what
    /// was kept of it is damaged or gone, counts once.
    [[nodiscard]] std::int64_t rendered() const { return rendered_; }
    /// The rays of these.
    [[nodiscard]] const render::RenderStatistics& counts() const { return counts_; }

  private:
    [[nodiscard]] bool try_make(std::size_t picture, const std::stop_token& stop);
    [[nodiscard]] bool try_held(const std::stop_token& stop);
    void repair(std::size_t picture, const std::stop_token& stop);
    void report(std::size_t picture, const CachedRender& made);

    const FilmPlan& plan_;
    CachedRenderer& renderer_;
    FrameQueue& queue_;
    ThreadSafeObserver& observer_;
    CacheKeeper* keeper_;
    std::deque<std::size_t> held_;  // by other processes
    std::vector<bool> is_reported_;
    std::vector<bool> is_rendered_;
    std::vector<int> repairs_;
    std::int64_t reported_frames_ = 0;
    std::int64_t rendered_ = 0;
    render::RenderStatistics counts_;
};

}  // namespace carom::pipeline
