// Many triangles under a wide tree, eight at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/acceleration/analytic_blocks.h"
#include "render/acceleration/test_counts.h"
#include "render/acceleration/triangle_scene.h"
#include "render/acceleration/wide_tree.h"

namespace carom::render {

/// Eight triangles. Unused lanes hold one without an area, which no ray meets.
struct alignas(64) TriangleBlock {
    Lanes corner[3];  // by axis
    Lanes edge_b[3], edge_c[3];
};

/// What a block's triangles are called.
struct TriangleNames {
    ObjectLanes object;
    ObjectLanes number;  // in its mesh
};

struct TriangleTree {
    WideTree tree;
    LargeVector<TriangleBlock> blocks;  // by leaf
    LargeVector<TriangleNames> names;   // by leaf
};

[[nodiscard]] TriangleTree make_triangle_tree(std::span<const MeshEntry> meshes);

/// Rays must be safe (safe_ray.h). The test gives the bits of moller_trumbore.h.
struct TriangleTreeKernels {
    /// As AnalyticTreeKernels::closest; of equally near hits that with the lower object, then the
    /// lower triangle.
    void (*closest)(const TriangleTree& tree, const Ray& ray, Hit& best);
    bool (*any)(const TriangleTree& tree, const Ray& ray);

    /// The same, what they take added to `counts`.
    void (*closest_counted)(const TriangleTree& tree, const Ray& ray, Hit& best,
                            KindCounts& counts);
    bool (*any_counted)(const TriangleTree& tree, const Ray& ray, KindCounts& counts);
};

[[nodiscard]] std::size_t bytes_of(const TriangleTree& tree);

[[nodiscard]] const TriangleTreeKernels& best_triangle_kernels();

}  // namespace carom::render
