// Counters that many threads add to.
#pragma once

#include <mutex>

#include "render/acceleration/test_counts.h"

namespace carom::render {

class SharedCounts {
  public:
    /// Adds the tests of one ray; `counts.rays` is ignored.
    void add_ray(RayKind kind, KindCounts counts) {
        counts.rays = 1;
        const std::scoped_lock lock(mutex_);
        counts_[kind] += counts;
    }
    [[nodiscard]] TestCounts current() const {
        const std::scoped_lock lock(mutex_);
        return counts_;
    }

  private:
    mutable std::mutex mutex_;
    TestCounts counts_;
};

}  // namespace carom::render
