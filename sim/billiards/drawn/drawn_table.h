// What is drawn of a billiard table. Balls do not meet these surfaces but those of build_table
// (table.h), so that the picture may follow the makers' shapes; docs/tables.md says where the two
// differ.
#pragma once

#include <vector>

#include "sim/billiards/table.h"

namespace carom::sim::billiards {

/// The drawn surfaces, for balls of this radius (as in build_table). Throws Error if the measures
/// have problems.
[[nodiscard]] std::vector<Surface> draw_table(const TableMeasures& measures, double ball_radius);

}  // namespace carom::sim::billiards
