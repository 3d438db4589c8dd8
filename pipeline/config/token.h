// How far the token at a place of a YAML text reaches, for the caret under it.
#pragma once

#include "pipeline/config/source_set.h"

namespace carom::pipeline::config {

/// The token at a line and a column in bytes (both from 0), behind its tag and anchor: a quoted
/// scalar with its quotes, an alias, a plain scalar up to its end on this line, or one bracket.
[[nodiscard]] Place token_at(const SourceSet& sources, int source, int line, int column_bytes);

}  // namespace carom::pipeline::config
