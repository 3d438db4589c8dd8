// The dimensions of a table as YAML.
#pragma once

#include "pipeline/config/node.h"
#include "sim/billiards/table.h"

namespace carom::pipeline::config {

/// A map with the keys of `table` for the dimensions of the table and its pockets, rounded to a
/// micrometre. The places of the nodes have no source. The map of an unbounded cloth is empty.
[[nodiscard]] Node table_node(const sim::billiards::TableMeasures& measures);

}  // namespace carom::pipeline::config
