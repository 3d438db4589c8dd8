// The measures of a table as the YAML that would give them.
#pragma once

#include "pipeline/config/node.h"
#include "sim/billiards/table.h"

namespace carom::pipeline::config {

/// A map with the keys of `table` that say how large it and its pockets are, in lengths rounded to
/// a micrometre. The nodes stand in no
/// text: their places name no source. A cloth without a table around it has no such keys.
[[nodiscard]] Node table_node(const sim::billiards::TableMeasures& measures);

}  // namespace carom::pipeline::config
