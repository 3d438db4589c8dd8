// Triangles taken apart into what a ball can touch: faces, edges and corners, each once.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/vectors.h"

namespace carom::sim {

/// A triangle, an edge or a corner of a mesh.
struct MeshFeature {
    enum class Kind : std::uint8_t { face, edge, corner } kind = Kind::face;
    std::array<Vec3, 3> points{};  // face: 3, edge: 2, corner: 1 of them
    Vec3 direction{0, 0, 0};       // unit; face: its normal, edge: from the first to the second
};

using MeshTriangle = std::array<std::uint32_t, 3>;

/// Takes a mesh apart. Edges between triangles in one plane are left out, and so are corners with
/// only such edges: a ball touches the faces there. Triangles without area are left out. There are
/// never more than seven features for each triangle.
[[nodiscard]] std::vector<MeshFeature> mesh_features(const std::vector<Vec3>& vertices,
                                                     const std::vector<MeshTriangle>& triangles);

/// The point of a feature nearest to `point`.
[[nodiscard]] Vec3 nearest_point(const MeshFeature& feature, const Vec3& point);

}  // namespace carom::sim
