// Smooth normals for meshes.
#pragma once

#include "render/geometry/triangle_mesh.h"

namespace carom::render {

/// Gives every corner the mean normal of the triangles at its position whose own normals are within
/// `crease` (rad) of its triangle's, weighted by their angles there (Thürmer and Wüthrich 1998,
/// "Computing vertex normals from polygonal facets"). Existing normals are replaced; vertices are
/// split at sharp edges; triangles keep their order.
void smooth_normals(TriangleMesh& mesh, double crease);

}  // namespace carom::render
