// Options of a structure and its queries.
#pragma once

#include "lab/structures/triangle_test.h"

namespace carom::render {

class SharedCounts;

/// Sizes that some structures of the laboratory leave open; 0: the structure's own.
struct StructureSizes {
    int leaf_capacity = 0;    // the most shapes that are not divided any further
    int node_capacity = 0;    // the most children of a node
    double grid_density = 0;  // cells per shape
};

struct StructureOptions {
    SharedCounts* counts = nullptr;  // if given, tests are counted; outlives the structure
    bool shadow_rays_stop = true;    // at the first hit; otherwise they find the nearest one
    StructureSizes sizes{};
    /// Instead of the renderer's test; for structures that test triangles one by one.
    TriangleTestMaker triangle_test{};
};

}  // namespace carom::render
