// Makes the observer of a job safe to call from several threads.
#pragma once

#include <mutex>

#include "pipeline/job/film_job.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// Passes on one call at a time, and one stage after the other: the progress of encoding is
/// reported only after rendering has ended.
class ThreadSafeObserver {
  public:
    explicit ThreadSafeObserver(const JobObserver& observer) : observer_(observer) {}

    /// Fractions never decrease: smaller ones are ignored.
    void render_progress(double fraction);
    void encode_progress(double fraction);
    void warning(const std::string& message);
    /// A warning if samples of this frame were unusable; only for the first such frame of the job.
    void check(const render::RenderStatistics& counts, std::int64_t frame);
    void frame(std::int64_t number, bool from_store, double seconds, std::uint64_t rays);

  private:
    void report_progress(std::string_view stage, double fraction);

    std::mutex mutex_;
    const JobObserver& observer_;
    double render_fraction_ = 0;
    double encode_fraction_ = 0;
    bool has_warned_of_samples_ = false;
};

}  // namespace carom::pipeline
