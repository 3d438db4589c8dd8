// What tells that rays need not be tested with triangles (kernels/culling.h), as plain data.
#pragma once

#include "render/geometry/ray.h"

namespace carom::render {

/// Two parallel planes with a leaf's triangles between them: low <= dot(normal, p) <= high. Where
/// the triangles are coplanar, rays that leave or do not reach them need no other test.
struct LeafSlab {
    V3f normal;
    float low, high;
    float size;      // the largest coordinate of a corner, m
    float rounding;  // bound on a hit's error along the normal, as a fraction of coordinates
    float edge;      // the largest sum of the sizes of an edge's coordinates, m
};

/// A Horizon (horizon.h). Borrows its arrays.
struct HorizonTables {
    float x = 0, y = 0;  // the corner of the first cell, m
    float cells_per_metre = 0;
    int width = 0, height = 0;  // cells; 0: there is no map
    const float* top = nullptr;
    const float* slope2 = nullptr;
};

}  // namespace carom::render
