// Keeps the cache within its limit while a job fills it.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "pipeline/job/thread_safe_observer.h"

namespace carom::pipeline {

/// Frames that the job has used or stored since this object was created are never removed, so a
/// film that is larger than the limit is finished nevertheless. For one thread at a time.
class CachePruner {
  public:
    /// `limit` in bytes. With kNoLimit nothing is removed.
    CachePruner(std::string cache_folder, std::uint64_t limit, ThreadSafeObserver& observer);

    /// Must be called after every picture that was stored. Prunes after every 32nd picture.
    void on_picture_stored();

    /// Prunes now. Warns once if what the job needs exceeds the limit. Does nothing if the folder
    /// cannot be read.
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
