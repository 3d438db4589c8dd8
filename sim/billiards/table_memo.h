// Tables that were built before, for programs that load similar shots again and again.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/lru_cache.h"
#include "sim/billiards/table.h"

namespace carom::sim::billiards {

/// Keeps the tables that were used last. May be used from any thread.
class TableMemo {
  public:
    /// As build_table.
    [[nodiscard]] std::shared_ptr<const TableGeometry> table(const TableMeasures& measures,
                                                             double ball_radius);

    /// As draw_table.
    [[nodiscard]] std::shared_ptr<const std::vector<Surface>> drawn(const TableMeasures& measures,
                                                                    double ball_radius);

  private:
    LruCache<std::pair<TableMeasures, double>, TableGeometry> tables_{4};
    LruCache<std::pair<TableMeasures, double>, std::vector<Surface>> drawn_{4};
};

}  // namespace carom::sim::billiards
