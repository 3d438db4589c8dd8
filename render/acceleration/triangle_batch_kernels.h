// Intersection of rays, mostly many at a time, with trees of triangles and of instances, for the
// best instruction set that the processor has.
#pragma once

#include <cstdint>

#include "render/acceleration/instance_tree.h"
#include "render/acceleration/ray_batch.h"
#include "render/acceleration/triangle_tree.h"

namespace carom::render {

/// The nearest hits of the rays of a batch, as arrays with room for 16 more numbers of any value.
/// Where object is -1 nothing is hit before t.
struct HitArrays {
    float* t = nullptr;
    std::int32_t* object = nullptr;
    std::int32_t* primitive = nullptr;
    float* u = nullptr;
    float* v = nullptr;
};

/// A ray's answer depends on nothing but the ray and the tree: not on other rays of the batch, and
/// not on the instruction set. Triangles are tested by triangle_hit(). A distance less than that
/// at which the ray enters the box of the triangle's leaf is replaced by the latter, so that the
/// order in which boxes are visited cannot matter. Tree: TriangleTree or InstanceTree.
template <class Tree>
struct TreeBatchKernels {
    /// Replaces the hit of each ray by a triangle's that is nearer, or equally near and of a lower
    /// object, then of a lower triangle. Rays with numbers that are not finite stay as they are.
    void (*closest)(const Tree& tree, const RayBatch& rays, const HitArrays& hits);
    /// Sets t[i] to 0 if ray i hits anything before it. Rays whose t is 0 are skipped.
    void (*occlude)(const Tree& tree, const RayBatch& rays, float* t);

    /// The nearest hit of one safe ray (safe_ray.h) in (t_min, t_max); without one, returns false
    /// and leaves `hit` untouched.
    bool (*closest_of_ray)(const Tree& tree, const Ray& ray, Hit& hit);
    bool (*any_of_ray)(const Tree& tree, const Ray& ray);
};

using TriangleBatchKernels = TreeBatchKernels<TriangleTree>;
using InstanceBatchKernels = TreeBatchKernels<InstanceTree>;

[[nodiscard]] const TriangleBatchKernels& best_triangle_batch_kernels();
[[nodiscard]] const InstanceBatchKernels& best_instance_batch_kernels();

}  // namespace carom::render
