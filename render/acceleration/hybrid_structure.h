// The default structure: analytic shapes in vector lanes, many of them in a tree, and the triangles
// of meshes in trees of their own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "render/acceleration/acceleration_structure.h"
#include "render/acceleration/analytic_kernels.h"
#include "render/acceleration/analytic_tree_kernels.h"
#include "render/acceleration/batch_kernels.h"
#include "render/acceleration/shapes.h"
#include "render/acceleration/triangle_batch_kernels.h"

namespace carom::render {

/// The loop_cost from which a tree is faster than testing all shapes
/// (docs/developers/performance.md).
inline constexpr std::size_t kTreeThreshold = 160;

/// The few spheres and boxes of a billiard shot are tested by brute force, eight at a time, which
/// no hierarchy beats. From a cost of `tree_threshold` on all shapes except infinite planes go into
/// a tree, which gives the same hits. Triangles are tested last, within the distance found. A tree
/// of many static shapes may be shared between frames; then only the other shapes are in `shapes`,
/// and they are tested in loops.
class HybridStructure final : public AccelerationStructure {
  public:
    explicit HybridStructure(const ShapeSet& shapes, std::size_t tree_threshold = kTreeThreshold);
    HybridStructure(const ShapeSet& shapes, std::shared_ptr<const AnalyticTree> static_tree);

    [[nodiscard]] bool closest_hit(const Ray& ray, Hit& hit) const override;
    [[nodiscard]] bool any_hit(const Ray& ray) const override;
    void closest_hits(const RayBatch& rays, Hit* hits) const override;
    void test_occlusion(const RayBatch& rays, float* t_max) const override;
    /// Memory of the trees.
    [[nodiscard]] std::size_t bytes() const;

  private:
    struct PartHits;

    void set_loops(const ShapeSet& shapes);
    [[nodiscard]] bool find_outside_tree(Ray remaining, Hit& best) const;
    void find_moving(const MovingShape& shape, const RayBatch& part, std::uint64_t rays_of_shape,
                     PartHits& best) const;
    void occlude_by_moving(const MovingShape& shape, const RayBatch& part,
                           std::uint64_t rays_of_shape, float* t) const;
    template <class Visit>
    void each_that_meets(std::span<const Imath::Box3f> boxes, const RayBatch& part, const float* t,
                         const Visit& visit) const;
    template <class Visit>
    void each_meeting(const RayBatch& part, const float* t, const Visit& visit) const;

    const AnalyticKernels& kernels_;
    const BatchKernels& batch_kernels_;
    const AnalyticTreeKernels& tree_kernels_;
    const InstanceBatchKernels& instance_kernels_;
    std::shared_ptr<const AnalyticTree> tree_;  // may be null
    LoopBlocks loops_;                          // shapes outside the tree
    MovingLoops moving_;                        // likewise
    InstanceTree instances_;
    std::shared_ptr<const TriangleScene> meshes_;
};

}  // namespace carom::render
