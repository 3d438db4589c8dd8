// Flat shapes as triangles, for emission.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/frame_scene/static_geometry.h"
#include "render/geometry/ray.h"

namespace carom::render {

/// In the axes of the body, or the world's for an object without a track; corners counter-clockwise
/// seen from the front. Empty for round and infinite shapes.
[[nodiscard]] std::vector<std::array<V3f, 3>> flat_faces(const StaticGeometry& geometry,
                                                         std::uint32_t object);

}  // namespace carom::render
