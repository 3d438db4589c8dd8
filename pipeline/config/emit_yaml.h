// Writes a tree of nodes as YAML text.
#pragma once

#include <map>
#include <string>

#include "pipeline/config/node.h"

namespace carom::pipeline::config {

/// Text that reads back as the same tree. `replaced` has texts that are written, in
/// quotes, instead of some values.
[[nodiscard]] std::string emit_yaml(const Node& root,
                                    const std::map<const Node*, std::string>& replaced = {});

/// One value on one line, in the form that is valid inside [ ] and { }.
[[nodiscard]] std::string emit_flow(const Node& node,
                                    const std::map<const Node*, std::string>& replaced = {});

/// A key, in quotes if it needs them.
[[nodiscard]] std::string emit_key(const std::string& key);

}  // namespace carom::pipeline::config
