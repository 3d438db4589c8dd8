// Queries of the product's trees that count their tests. Boxes and shapes are counted by the lanes
// in use, because the others are tested without need.
#pragma once

#include "lab/structures/test_counts.h"
#include "render/acceleration/analytic_tree.h"
#include "render/acceleration/instance_tree.h"
#include "render/acceleration/triangle_tree.h"

namespace carom::render {

/// Rays must be safe (safe_ray.h). `best` is replaced by a nearer hit, or by an equally near one of
/// a lower object or triangle; one without an object stands for the end of the ray. All shapes of a
/// block are counted, even if a hit was found in a part of them. An instance is one shape.
void closest_counted(const AnalyticTree& tree, const Ray& ray, Hit& best, KindCounts& counts);
void closest_counted(const TriangleTree& tree, const Ray& ray, Hit& best, KindCounts& counts);
void closest_counted(const InstanceTree& tree, const Ray& ray, Hit& best, KindCounts& counts);
[[nodiscard]] bool any_counted(const AnalyticTree& tree, const Ray& ray, KindCounts& counts);
[[nodiscard]] bool any_counted(const TriangleTree& tree, const Ray& ray, KindCounts& counts);
[[nodiscard]] bool any_counted(const InstanceTree& tree, const Ray& ray, KindCounts& counts);

}  // namespace carom::render
