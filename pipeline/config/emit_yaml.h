// A tree of nodes as YAML text.
#pragma once

#include <map>
#include <string>

#include "pipeline/config/node.h"

namespace carom::pipeline::config {

/// Reads back as the same tree. `replaced` gives other texts for some scalars.
[[nodiscard]] std::string emit_yaml(const Node& root,
                                    const std::map<const Node*, std::string>& replaced = {});

}  // namespace carom::pipeline::config
