// Counters that many threads add to.
#pragma once

#include <mutex>
#include <utility>

#include "lab/structures/test_counts.h"

namespace carom::render {

class SharedCounts {
  public:
    /// Adds the tests of one ray; `counts.rays` is ignored.
    void add_ray(RayKind kind, KindCounts counts) {
        counts.rays = 1;
        const std::scoped_lock lock(mutex_);
        counts_[kind] += counts;
    }
    /// All since the last call.
    [[nodiscard]] TestCounts take() {
        const std::scoped_lock lock(mutex_);
        return std::exchange(counts_, {});
    }

  private:
    std::mutex mutex_;
    TestCounts counts_;
};

}  // namespace carom::render
