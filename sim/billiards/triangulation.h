// Triangulation of planar regions, for all flat parts of a table.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vectors.h"

namespace carom::sim::billiards {

struct Triangulation {
    std::vector<Vec2> points;  // those of the loops in their order, then inner points
    std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise
};

using Loop = std::vector<Vec2>;

/// Constrained Delaunay triangulation of the region inside loops[0] and outside the other loops.
/// Loops are simple, do not touch each other, and may have either orientation. Every edge of a loop
/// is an edge of a triangle, so that parts with a common outline fit without gaps. Where there is
/// room, points are added `spacing` (> 0, m) apart to avoid long triangles. Throws Error if the
/// loops are not as described.
[[nodiscard]] Triangulation triangulate(std::span<const Loop> loops, double spacing);

}  // namespace carom::sim::billiards
