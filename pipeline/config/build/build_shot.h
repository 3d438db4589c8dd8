// From what the YAML says to a Shot: names looked up, geometry made, defaults filled in.
#pragma once

#include <string>

#include "pipeline/config/node.h"
#include "pipeline/config/reader.h"
#include "pipeline/config/shot_file.h"
#include "pipeline/shot/shot.h"

namespace carom::pipeline::config {

/// Problems go to the reader; after an error the shot is of no use. `root` is the tree that `file`
/// was read from, for places.
[[nodiscard]] Shot build_shot(const ShotFile& file, const Node& root, const std::string& name,
                              Reader& reader);

}  // namespace carom::pipeline::config
