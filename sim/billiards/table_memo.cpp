#include "sim/billiards/table_memo.h"

namespace carom::sim::billiards {

std::shared_ptr<const TableGeometry> TableMemo::table(const TableMeasures& measures,
                                                      double ball_radius) {
    return tables_.get({measures, ball_radius}, [&] { return build_table(measures, ball_radius); });
}

}  // namespace carom::sim::billiards
