// Flat static shapes as triangles, for emission.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/frame_scene/static_geometry.h"
#include "render/geometry/ray.h"

namespace carom::render {

/// World axes, corners counter-clockwise seen from the front. Empty for objects with a track and
/// for round and infinite shapes.
[[nodiscard]] std::vector<std::array<V3f, 3>> static_triangles(const StaticGeometry& geometry,
                                                               std::uint32_t object);

}  // namespace carom::render
