// Merges the files and options of a shot in the order of their precedence.
#pragma once

#include "pipeline/config/node.h"
#include "pipeline/config/problem_list.h"
#include "pipeline/config/source_set.h"

namespace carom::pipeline::config {

/// Merges `layer`, which has precedence, into `base`; both have the structure of a shot. If the
/// layer has `render.size` without `render.short_side`, it means exactly that size, so a
/// `short_side` of `base`, which would scale it, is removed.
void merge_layer(Node& base, Node layer);

/// Like merge_layer for a --set, which is the text `source` of `sources`.
void merge_override(Node& root, SourceSet& sources, int source, ProblemList& problems);

}  // namespace carom::pipeline::config
