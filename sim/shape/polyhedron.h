// The convex hull of points.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/vectors.h"

namespace carom::sim {

/// A flat side; its corners are counter-clockwise seen from outside.
struct PolyhedronFace {
    std::vector<std::uint32_t> corners;
    Vec3 normal{0, 0, 1};  // unit, outwards
};

struct Polyhedron {
    std::vector<Vec3> vertices;
    std::vector<PolyhedronFace> faces;
};

/// The hull of `points`; empty if they are fewer than four or lie in a plane (within 1e-6 of their
/// extent). Inner points are omitted; triangles in one plane (within 1e-7 of the extent) are merged
/// into one face.
[[nodiscard]] std::optional<Polyhedron> convex_hull(std::span<const Vec3> points);

}  // namespace carom::sim
