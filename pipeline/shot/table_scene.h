// The surfaces of a table as objects of the scene.
#pragma once

#include <vector>

#include "render/scene/scene_description.h"
#include "sim/billiards/table.h"

namespace carom::pipeline {

inline constexpr const char* kFloorName = "table/floor";

/// Adds the drawn surfaces of a table under the names "table/NAME", with the materials of their
/// parts, and the floor that the table stands on (kFloorName; not under an unbounded cloth).
void add_table(render::SceneDescription& scene, const sim::billiards::TableMeasures& measures,
               const std::vector<sim::billiards::Surface>& surfaces);

}  // namespace carom::pipeline
