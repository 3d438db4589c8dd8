// Tables that were built before, for programs that load similar shots again and again.
#pragma once

#include <deque>
#include <memory>
#include <mutex>

#include "sim/billiards/table.h"

namespace carom::sim::billiards {

/// Keeps the tables that were used last. May be used from any thread.
class TableMemo {
  public:
    /// As build_table with all parts.
    [[nodiscard]] std::shared_ptr<const TableGeometry> table(const TableMeasures& measures,
                                                             double ball_radius);

  private:
    struct Entry {
        TableMeasures measures;
        double ball_radius = 0;
        std::shared_ptr<const TableGeometry> geometry;
    };
    std::mutex mutex_;
    std::deque<Entry> entries_;  // the last used ones at the end
};

}  // namespace carom::sim::billiards
