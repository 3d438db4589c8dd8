// A shot with all its values and the place where each was set.
#pragma once

#include <string>

#include "pipeline/config/shot_source.h"
#include "pipeline/shot/shot.h"

namespace carom::pipeline {

/// The whole shot after includes, presets and overrides, as YAML that reads back as the same shot
/// (except for the last digits of defaults). Each line has one value, with a comment that names the
/// file and line (or the option) that set it, or says that it is the default. Defaults that follow
/// from other values (a ball's mass from its size) or have no meaning beside them are omitted,
/// except the measures of a standard table, which are written as comments. The comment of a
/// `short_side` also gives the size of the picture.
[[nodiscard]] std::string explained_yaml(const ShotSource& source, const Shot& shot);

}  // namespace carom::pipeline
