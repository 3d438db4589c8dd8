// What a shot shows unless its look says otherwise.
#pragma once

#include <string_view>
#include <vector>

#include "render/scene/scene_description.h"
#include "sim/billiards/table.h"

namespace carom::pipeline {

/// Materials by the names that a look may define anew: "cloth", "cushion", "rail", "pocket_liner",
/// "pocket_floor", "apron", "leg", "sight", "floor", "ball" (the finish of all balls; their colours
/// come on top) and "plain".
[[nodiscard]] const std::vector<render::MaterialDescription>& default_materials();

/// The name of the material that a part of the table has.
[[nodiscard]] std::string_view material_of(sim::billiards::SurfacePart part);

/// A lamp above the middle of the table and a dim room. Without a table: above the origin.
[[nodiscard]] std::vector<render::LightDescription> default_lights(
    const sim::billiards::TableMeasures* table);

}  // namespace carom::pipeline
