// Default materials and lights of a shot.
#pragma once

#include <string_view>
#include <vector>

#include "render/scene/scene_description.h"
#include "sim/billiards/table.h"

namespace carom::pipeline {

/// The default materials, which a look may replace by name: "cloth", "cushion", "rail", "casting",
/// "pocket_liner", "pocket_floor", "stitch", "net", "apron", "leg", "sight", "name_plate", "line",
/// "spot", "floor", "ball" (the finish of all balls, without their colours), "plain", and those of
/// the cue stick (cue_stick.h).
[[nodiscard]] const std::vector<render::MaterialDescription>& default_materials();

/// The name of the default material of a part of the table.
[[nodiscard]] std::string_view material_of(sim::billiards::SurfacePart part);

/// A lamp above the centre of the table and a dim room. Without a table the lamp is above the
/// origin.
[[nodiscard]] std::vector<render::LightDescription> default_lights(
    const sim::billiards::TableMeasures* table);

}  // namespace carom::pipeline
