// Between the threads of a job and the one observer who listens to it.
#pragma once

#include <mutex>

#include "pipeline/job/film_job.h"

namespace carom::pipeline {

/// Lets one call through at a time. Stages come one after the other: what is said of encoding while
/// rendering still goes on is kept back.
class ThreadSafeObserver {
  public:
    explicit ThreadSafeObserver(const JobObserver& observer) : observer_(observer) {}

    /// Shares never decrease; smaller ones are dropped.
    void render_progress(double fraction);
    void encode_progress(double fraction);
    void warning(const std::string& message);
    void frame(std::int64_t number, bool from_store, double seconds, std::uint64_t rays);

  private:
    void tell(std::string_view stage, double fraction);

    std::mutex mutex_;
    const JobObserver& observer_;
    double render_fraction_ = 0;
    double encode_fraction_ = 0;
};

}  // namespace carom::pipeline
