// Analytic shapes in the lanes of vectors, many of them under a tree, meshes in Embree.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "render/acceleration/analytic_kernels.h"
#include "render/acceleration/analytic_tree_kernels.h"
#include "render/acceleration/batch_kernels.h"
#include "render/acceleration/measured_structure.h"
#include "render/acceleration/shapes.h"

namespace carom::render {

/// From which loop_cost on a tree is faster than testing all (docs/developers/performance.md).
inline constexpr std::size_t kTreeThreshold = 160;

/// The default. The handful of balls and boxes of a billiard shot is tested by brute force, eight
/// at a time, which no hierarchy beats; from a cost of `tree_threshold` on all but infinite planes
/// go into a tree instead, which gives the same hits. Only then are triangles asked, within the
/// distance found. Many still shapes may come in a tree that frames share; then only the others are
/// in `shapes`, and they are tested in loops.
class HybridStructure final : public MeasuredStructure {
  public:
    explicit HybridStructure(const ShapeSet& shapes, std::size_t tree_threshold = kTreeThreshold);
    HybridStructure(const ShapeSet& shapes, std::shared_ptr<const AnalyticTree> still);

    [[nodiscard]] bool closest_hit(const Ray& ray, Hit& hit) const override;
    [[nodiscard]] bool any_hit(const Ray& ray) const override;
    [[nodiscard]] FanMask any_hits(const RayFan& fan) const override;
    void closest_hits(const RayBatch& rays, Hit* hits) const override;
    void drop_blocked(const RayBatch& rays, float* reach) const override;
    [[nodiscard]] std::size_t bytes() const override;

  private:
    void set_loops(const ShapeSet& shapes);
    void find_in_tree(const Ray& ray, Hit& best) const;
    [[nodiscard]] bool find_among_others(Ray remaining, Hit& best) const;

    const AnalyticKernels& kernels_;
    const BatchKernels& batch_kernels_;
    const AnalyticTreeKernels& tree_kernels_;
    std::shared_ptr<const AnalyticTree> tree_;  // or null
    AnalyticBlocks blocks_;                     // what is not in the tree
    std::vector<MovingShape> moving_;           // the same
    std::shared_ptr<const TriangleScene> meshes_;
};

}  // namespace carom::render
