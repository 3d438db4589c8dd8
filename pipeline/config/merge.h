// Merges one tree of YAML into another.
#pragma once

#include <string>
#include <string_view>

#include "pipeline/config/node.h"
#include "pipeline/config/problem_list.h"

namespace carom::pipeline::config {

/// Merges maps key by key; all other values of `over` replace those of `base`. A null removes a key
/// of the base. If the base does not have the key, the null remains and is reported when it is
/// read.
void merge(Node& base, Node over);

/// Applies "a.b[0].c=VALUE" (text `source` of `sources`) to `root`: VALUE is YAML and is merged.
/// Missing maps of the path are created; list elements are selected by their index or their key
/// `name`.
void apply_override(Node& root, SourceSet& sources, int source, ProblemList& problems);

/// The value at a path such as "a.b[0].c", or nullptr.
[[nodiscard]] const Node* value_at(const Node& root, const std::string& path);

}  // namespace carom::pipeline::config
