// Laying one tree of YAML over another.
#pragma once

#include <string>
#include <string_view>

#include "pipeline/config/node.h"
#include "pipeline/config/problem_list.h"

namespace carom::pipeline::config {

/// Maps merge key by key, everything else of `over` replaces what `base` has. A null takes a key of
/// the base away; where the base has none it stays, and is reported when it is read.
void merge(Node& base, Node over);

/// Applies "a.b[0].c=VALUE" (text `source` of `sources`) to `root`: VALUE is YAML and is merged in.
/// Maps on the way are made; list elements are named by their index or by their key `name`.
void apply_override(Node& root, SourceSet& sources, int source, ProblemList& problems);

}  // namespace carom::pipeline::config
