#include "sim/billiards/table_memo.h"

#include "sim/billiards/drawn/drawn_table.h"

namespace carom::sim::billiards {

std::shared_ptr<const TableGeometry> TableMemo::table(const TableMeasures& measures,
                                                      double ball_radius) {
    return tables_.get({measures, ball_radius}, [&] { return build_table(measures, ball_radius); });
}

std::shared_ptr<const std::vector<Surface>> TableMemo::drawn(const TableMeasures& measures,
                                                             double ball_radius) {
    return drawn_.get({measures, ball_radius}, [&] { return draw_table(measures, ball_radius); });
}

}  // namespace carom::sim::billiards
