// Lights with a surface that rays can hit, from their descriptions. Formulas are in
// kernels/area_light.h.
#pragma once

#include <optional>

#include "render/light/light_tree.h"
#include "render/scene/scene_description.h"

namespace carom::render {

struct AreaLight {
    AreaLightConstants constants;
    Mat44 world_from_unit;
};

/// In the world's axes.
[[nodiscard]] LightBounds bounds_of(const AreaLightConstants& light);

/// Empty if the light has no surface.
[[nodiscard]] std::optional<AreaLight> area_light_of(const LightDescription& description);

}  // namespace carom::render
