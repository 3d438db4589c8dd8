// The keys of an object's shapes.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/map_spec.h"
#include "pipeline/config/shot_file.h"

namespace carom::pipeline::config {

/// `sphere`, `box`, ...: an object has exactly one of these.
[[nodiscard]] const std::vector<std::string>& shape_keys();

/// Adds them to an object's keys.
void add_shapes(MapSpec<ObjectSection>& s);

}  // namespace carom::pipeline::config
