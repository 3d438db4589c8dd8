// Warns of stored frames that turned out to be damaged.
#pragma once

#include <mutex>
#include <string>

#include "pipeline/job/thread_safe_observer.h"

namespace carom::pipeline {

/// Gives a warning for each of the first few frames and, when this object is destroyed at the end
/// of the job, one warning for all others, so that a failing disk is reported but does not fill the
/// screen. Any thread may call at any time.
class DamageReport {
  public:
    explicit DamageReport(ThreadSafeObserver& observer) : observer_(observer) {}
    ~DamageReport();
    DamageReport(const DamageReport&) = delete;
    DamageReport& operator=(const DamageReport&) = delete;
    DamageReport(DamageReport&&) = delete;
    DamageReport& operator=(DamageReport&&) = delete;

    void add(const std::string& path, const std::string& damage);

  private:
    ThreadSafeObserver& observer_;
    std::mutex mutex_;
    int count_ = 0;
};

}  // namespace carom::pipeline
