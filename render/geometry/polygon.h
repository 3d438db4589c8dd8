// Triangulation of polygons.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/vectors.h"

namespace carom::render {

using PolygonTriangles = std::vector<std::array<std::uint32_t, 3>>;  // indices into the corners

/// Triangulates a polygon (>= 3 corners in order, roughly flat, convex or not) into corners - 2
/// triangles of the same orientation, by ear clipping (Meisters 1975, "Polygons have ears"). The
/// polygon may touch itself: holes may be joined with the outline by edges that are passed twice,
/// and corners may be repeated. A polygon that intersects itself gets some triangulation. `work` is
/// the number of comparisons of a corner with a triangle that may be made, and is reduced by those
/// that were; nothing is returned if they do not suffice.
[[nodiscard]] std::optional<PolygonTriangles> triangulate(std::span<const Vec3> corners,
                                                          std::size_t& work);

/// Cuts the polygons of a file, in a time that is proportional to their corners.
class PolygonCutter {
  public:
    /// `corner_count`: of all polygons together.
    explicit PolygonCutter(std::size_t corner_count);

    /// Appends the triangles of a polygon, as indices of vertices. False if all polygons so far
    /// have so many notches that the work is too much.
    [[nodiscard]] bool cut(std::span<const Vec3> vertices, std::span<const std::uint32_t> polygon,
                           PolygonTriangles& triangles);

  private:
    std::size_t work_;
    std::vector<Vec3> corners_;
};

/// What to say if `cut` returns false.
inline constexpr const char* kTooManyCorners =
    "its polygons have so many corners that cutting them into triangles takes too long; let the "
    "program that wrote the file triangulate them";

}  // namespace carom::render
