// Rays against trees of analytic shapes, for the same instruction set as analytic_kernels.h.
#pragma once

#include "render/acceleration/analytic_tree.h"
#include "render/acceleration/test_counts.h"
#include "render/geometry/ray.h"

namespace carom::render {

/// Rays must be safe (safe_ray.h). A shape is tested by the same code as by AnalyticKernels, so the
/// hits are the same to the last bit.
struct AnalyticTreeKernels {
    /// `best.t` begins as the ray's t_max and `best.object` as kNoObject. A hit replaces it if it
    /// is nearer, or as near and of a lower object.
    void (*closest)(const AnalyticTree& tree, const Ray& ray, Hit& best);
    bool (*any)(const AnalyticTree& tree, const Ray& ray);

    /// The same, what they take added to `counts`.
    void (*closest_counted)(const AnalyticTree& tree, const Ray& ray, Hit& best,
                            KindCounts& counts);
    bool (*any_counted)(const AnalyticTree& tree, const Ray& ray, KindCounts& counts);
};

[[nodiscard]] const AnalyticTreeKernels& best_tree_kernels();

}  // namespace carom::render
