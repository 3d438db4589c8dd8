// Laying the files and options of a shot over each other.
#pragma once

#include "pipeline/config/node.h"
#include "pipeline/config/problem_list.h"
#include "pipeline/config/source_set.h"

namespace carom::pipeline::config {

/// Merges the stronger `layer` into `base`, both of them whole shots. A layer that gives
/// `render.size` without `render.short_side` means exactly that size, so a `short_side` of `base`,
/// which would scale it, is removed.
void lay_over(Node& base, Node layer);

/// The same for a --set, which is text `source` of `sources`.
void lay_override_over(Node& root, SourceSet& sources, int source, ProblemList& problems);

}  // namespace carom::pipeline::config
