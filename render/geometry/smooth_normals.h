// Normals for meshes that come without.
#pragma once

#include "render/geometry/triangle_mesh.h"

namespace carom::render {

/// Gives every corner the mean normal of the triangles around its place whose own normals are
/// within `crease` (rad) of its triangle's, weighted by the angles that they have there (Thürmer
/// and Wüthrich 1998, "Computing vertex normals from polygonal facets"). Normals that the mesh has
/// are replaced; vertices are split where an edge stays sharp; triangles keep their order.
void smooth_normals(TriangleMesh& mesh, double crease);

}  // namespace carom::render
