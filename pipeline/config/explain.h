// A shot as it was understood: every value with where it came from.
#pragma once

#include <string>

#include "pipeline/config/shot_source.h"
#include "pipeline/shot/shot.h"

namespace carom::pipeline {

/// The whole shot after includes, presets and overrides, as YAML that reads back as the same shot
/// (to the last digits of defaults): one value a line, with a comment that says which line of which
/// file (or which option) gave it, or that it is the default. Defaults that follow from other
/// values (a ball's mass from its size) or have no meaning beside them are left out, except the
/// measures of a standard table, which stand in comments. Beside a `short_side` stands the size
/// that the picture has by it.
[[nodiscard]] std::string explained_yaml(const ShotSource& source, const Shot& shot);

}  // namespace carom::pipeline
