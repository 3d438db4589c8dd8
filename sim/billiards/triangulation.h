// Plane regions as triangles: what all flat parts of a table are drawn with.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vectors.h"

namespace carom::sim::billiards {

struct Triangulation {
    std::vector<Vec2> points;  // those of the loops in their order, then points of the inside
    std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise
};

using Loop = std::vector<Vec2>;

/// Constrained Delaunay triangulation of the region inside loops[0] and outside the other loops,
/// which are simple, do not meet, and go round in any direction. Every edge of a loop is an edge of
/// a triangle, so that parts that share an outline fit without gaps. Where there is room, points
/// are added `spacing` (> 0, m) apart to keep triangles from growing long. Throws Error if the
/// loops are not as described.
[[nodiscard]] Triangulation triangulate(std::span<const Loop> loops, double spacing);

}  // namespace carom::sim::billiards
