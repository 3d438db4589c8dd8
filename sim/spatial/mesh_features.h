// Decomposition of a triangle mesh into its faces, edges and corners, each once.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/vectors.h"

namespace carom::sim {

/// A triangle, an edge or a corner of a mesh.
struct MeshFeature {
    enum class Kind : std::uint8_t { face, edge, corner } kind = Kind::face;
    std::array<Vec3, 3> points{};  // a face uses 3, an edge 2, a corner 1
    Vec3 direction{0, 0, 0};       // unit; face: its normal, edge: from the first to the second
};

using MeshTriangle = std::array<std::uint32_t, 3>;

/// The features of a mesh that a ball can touch. Edges between triangles in one plane, and corners
/// with only such edges, are omitted because a ball touches the faces there. Triangles without area
/// are omitted. There are at most seven features per triangle.
[[nodiscard]] std::vector<MeshFeature> mesh_features(const std::vector<Vec3>& vertices,
                                                     const std::vector<MeshTriangle>& triangles);

/// The point of a feature nearest to `point`.
[[nodiscard]] Vec3 nearest_point(const MeshFeature& feature, const Vec3& point);

}  // namespace carom::sim
