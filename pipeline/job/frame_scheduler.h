// The rendering side of a job: ensures that the store has every picture of the film.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

#include "pipeline/job/cached_renderer.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/job/frame_queue.h"
#include "pipeline/job/thread_safe_observer.h"
#include "pipeline/store/wait_notice.h"

namespace carom::pipeline {

/// Renders the pictures in order of first use. A picture that another process is rendering is
/// deferred. A picture that the encoder cannot read is rendered again immediately. Refers to its
/// arguments.
class FrameScheduler {
  public:
    /// `on_stored`, if not empty, is called for every picture that was rendered and stored, with
    /// its number in the plan. What it throws ends the job.
    FrameScheduler(const FilmPlan& plan, CachedRenderer& renderer, FrameQueue& queue,
                   ThreadSafeObserver& observer,
                   std::function<void(std::size_t picture)> on_stored = {})
        : plan_(plan),
          renderer_(renderer),
          queue_(queue),
          observer_(observer),
          on_stored_(std::move(on_stored)),
          is_reported_(plan.pictures.size(), false),
          is_rendered_(plan.pictures.size(), false),
          repairs_(plan.pictures.size(), 0) {}

    /// Returns when the reader of the queue is done. Throws Error, Stopped.
    void run(const std::stop_token& stop);

    /// How many pictures were rendered instead of found in the store. A picture that is rendered
    /// again, because its file is damaged or missing, counts once.
    [[nodiscard]] std::int64_t rendered() const { return rendered_; }
    /// The rays of the rendered pictures.
    [[nodiscard]] const render::RenderStatistics& counts() const { return counts_; }

  private:
    /// False if another process has claimed the picture.
    [[nodiscard]] bool try_render(std::size_t picture, const std::stop_token& stop);
    /// Returns after the first deferred picture that is finished; false if none could be.
    [[nodiscard]] bool retry_deferred(const std::stop_token& stop);
    void wait_for_others(const std::stop_token& stop);
    void repair(std::size_t picture, const std::stop_token& stop);
    void report(std::size_t picture, const CachedRender& result);

    const FilmPlan& plan_;
    CachedRenderer& renderer_;
    FrameQueue& queue_;
    ThreadSafeObserver& observer_;
    std::function<void(std::size_t picture)> on_stored_;
    std::deque<std::size_t> deferred_;  // pictures that other processes have claimed
    WaitNotice wait_;                   // for them
    std::vector<bool> is_reported_;
    std::vector<bool> is_rendered_;
    std::vector<int> repairs_;
    std::int64_t reported_frames_ = 0;
    std::int64_t rendered_ = 0;
    render::RenderStatistics counts_;
};

}  // namespace carom::pipeline
