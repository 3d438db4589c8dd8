// Polygons into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vectors.h"

namespace carom::render {

/// Cuts a polygon (>= 3 corners, roughly flat, in order around it, convex or not) into corners - 2
/// triangles of the same orientation, by clipping ears (Meisters 1975, "Polygons have ears"). Each
/// triangle holds positions in `corners`. A polygon that crosses itself gives some triangulation.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners);

}  // namespace carom::render
