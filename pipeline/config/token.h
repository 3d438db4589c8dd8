// The extent of the token at a place of a YAML text, for the caret under it.
#pragma once

#include "pipeline/config/source_set.h"

namespace carom::pipeline::config {

/// The token at a line and a column in bytes (both counted from 0), after its tag and anchor: a
/// quoted scalar with its quotes, an alias, a plain scalar up to its end on this line, or one
/// bracket.
[[nodiscard]] Place token_at(const SourceSet& sources, int source, int line, int column_bytes);

}  // namespace carom::pipeline::config
