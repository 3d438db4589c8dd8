// What something of the picture covers, seen from above.
#pragma once

#include <vector>

#include "render/scene/scene_description.h"

namespace carom::pipeline {

/// Points of the world that the convex outline of the object, at its place in `world_from_object`,
/// is made of; none for an infinite plane and for a mesh whose file cannot be read.
[[nodiscard]] std::vector<Vec3> outline_points(const render::ObjectDescription& object);

}  // namespace carom::pipeline
