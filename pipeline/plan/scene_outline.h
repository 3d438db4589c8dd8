// Outlines of scene objects, seen from above.
#pragma once

#include <vector>

#include "render/scene/scene_description.h"

namespace carom::pipeline {

/// World points whose convex hull contains the object at its pose `world_from_object`. Empty for an
/// infinite plane and for a mesh whose file cannot be read.
[[nodiscard]] std::vector<Vec3> outline_points(const render::ObjectDescription& object);

}  // namespace carom::pipeline
