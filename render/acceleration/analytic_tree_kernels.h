// Rays against trees of analytic shapes, for the same instruction set as analytic_kernels.h.
#pragma once

#include "render/acceleration/analytic_tree.h"
#include "render/geometry/ray.h"

namespace carom::render {

/// Rays must be safe (safe_ray.h). A shape is tested by the same code as by AnalyticKernels, so the
/// hits are the same to the last bit.
struct AnalyticTreeKernels {
    /// `best.t` begins as the ray's t_max and `best.object` as kNoObject. A hit replaces it if it
    /// is nearer, or as near and of a lower object.
    void (*closest)(const AnalyticTree& tree, const Ray& ray, Hit& best);
    bool (*any)(const AnalyticTree& tree, const Ray& ray);
};

[[nodiscard]] const AnalyticTreeKernels& best_tree_kernels();

}  // namespace carom::render
