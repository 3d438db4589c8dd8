// Many triangles under a wide tree, eight at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/acceleration/analytic_blocks.h"
#include "render/acceleration/triangle_scene.h"
#include "render/acceleration/wide_tree.h"

namespace carom::render {

/// Eight triangles. Unused lanes hold one without an area, which no ray meets.
struct TriangleBlock {
    Lanes corner[3];  // by axis
    Lanes edge_b[3], edge_c[3];
    ObjectLanes object;
    ObjectLanes number;  // in its mesh
};

struct TriangleTree {
    WideTree tree;
    std::vector<TriangleBlock> blocks;  // by leaf
};

[[nodiscard]] TriangleTree make_triangle_tree(std::span<const MeshEntry> meshes);

/// Rays must be safe (safe_ray.h). The test gives the bits of moller_trumbore.h.
struct TriangleTreeKernels {
    /// As AnalyticTreeKernels::closest; of equally near hits that with the lower object, then the
    /// lower triangle.
    void (*closest)(const TriangleTree& tree, const Ray& ray, Hit& best);
    bool (*any)(const TriangleTree& tree, const Ray& ray);
};

[[nodiscard]] const TriangleTreeKernels& best_triangle_kernels();

}  // namespace carom::render
