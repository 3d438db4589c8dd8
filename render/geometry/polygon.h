// Triangulation of polygons.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vectors.h"

namespace carom::render {

/// Triangulates a polygon (>= 3 corners in order, roughly flat, convex or not) into corners - 2
/// triangles of the same orientation, by ear clipping (Meisters 1975, "Polygons have ears"). Each
/// triangle contains indices into `corners`. A polygon that intersects itself gets some
/// triangulation.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners);

}  // namespace carom::render
