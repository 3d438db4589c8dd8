// The keys for the shapes of objects.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/map_spec.h"
#include "pipeline/config/shot_file.h"

namespace carom::pipeline::config {

/// `sphere`, `box`, ...: an object has exactly one of these.
[[nodiscard]] const std::vector<std::string>& shape_keys();

/// Adds these keys to those of an object.
void add_shapes(MapSpec<ObjectSection>& s);

}  // namespace carom::pipeline::config
