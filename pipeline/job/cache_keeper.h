// Keeps the cache within its limit while a job fills it.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "pipeline/job/thread_safe_observer.h"

namespace carom::pipeline {

/// Frames that the job has used or made since this object began are never removed: a film that is
/// larger than the limit is finished nevertheless. For one thread at a time.
class CacheKeeper {
  public:
    /// `limit` in bytes; kNoLimit: does nothing.
    CacheKeeper(std::string cache_folder, std::uint64_t limit, ThreadSafeObserver& observer);

    /// To be called after every picture that was stored; every now and then it prunes.
    void picture_stored();

    /// Prunes now. Says so, once, if what the job needs is more than the limit. A folder that
    /// cannot be read is left alone.
    void prune();

  private:
    std::string cache_folder_;
    std::uint64_t limit_;
    ThreadSafeObserver& observer_;
    std::chrono::system_clock::time_point begin_;
    int stored_ = 0;
    bool has_warned_ = false;
};

}  // namespace carom::pipeline
