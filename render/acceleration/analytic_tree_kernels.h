// Intersection of rays with trees of analytic shapes, for the same instruction set as
// analytic_kernels.h.
#pragma once

#include "render/acceleration/analytic_tree.h"
#include "render/geometry/ray.h"

namespace carom::render {

/// Rays must be safe (safe_ray.h). Shapes are tested by the same code as in AnalyticKernels, so
/// that the hits have the same bits.
struct AnalyticTreeKernels {
    /// `best.t` begins as the ray's t_max and `best.object` as kNoObject. A nearer hit replaces it,
    /// or an equally near one of a lower object.
    void (*closest)(const AnalyticTree& tree, const Ray& ray, Hit& best);
    bool (*any)(const AnalyticTree& tree, const Ray& ray);
};

[[nodiscard]] const AnalyticTreeKernels& best_tree_kernels();

}  // namespace carom::render
