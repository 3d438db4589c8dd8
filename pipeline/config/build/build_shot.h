// Builds a Shot from the sections of the YAML: resolves names, builds geometry, fills in defaults.
#pragma once

#include <string>

#include "pipeline/config/node.h"
#include "pipeline/config/reader.h"
#include "pipeline/config/shot_file.h"
#include "pipeline/shot/shot.h"
#include "sim/billiards/table_memo.h"

namespace carom::pipeline::config {

/// Problems go to the reader; after an error the shot is invalid. `root` is the tree from which
/// `file` was read, for places. `tables` has tables that were built before; it may be null.
[[nodiscard]] Shot build_shot(const ShotFile& file, const Node& root, const std::string& name,
                              Reader& reader, sim::billiards::TableMemo* tables = nullptr);

}  // namespace carom::pipeline::config
