// Triangle meshes in a tree of their own.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/acceleration/mesh_entry.h"
#include "render/acceleration/ray_batch.h"
#include "render/acceleration/triangle_batch_kernels.h"
#include "render/acceleration/triangle_tree.h"
#include "render/geometry/ray.h"

namespace carom::render {

/// Trees over the triangles of meshes; immutable after construction and shared by threads. Meshes
/// that are apart, such as a table and the lamps above it, have trees of their own. The same meshes
/// give the same hits, bit for bit, on every processor, whether a ray is asked alone or among
/// others.
class TriangleScene {
  public:
    /// Copies what it needs of the meshes.
    explicit TriangleScene(std::span<const MeshEntry> meshes);

    /// The nearest hit in (t_min, t_max) of a safe ray (safe_ray.h); without one, returns false and
    /// leaves `hit` untouched. Of triangles at exactly the same distance the one with the lower
    /// object, then the lower index, is reported.
    [[nodiscard]] bool closest_hit(const Ray& ray, Hit& hit) const;
    [[nodiscard]] bool any_hit(const Ray& ray) const;

    /// See TriangleBatchKernels.
    void closest_hits(const RayBatch& rays, const HitArrays& hits) const;
    /// See AccelerationStructure.
    void test_occlusion(const RayBatch& rays, float* t_max) const;

    [[nodiscard]] std::size_t bytes() const;

  private:
    const TriangleBatchKernels& kernels_;
    std::vector<TriangleTree> trees_;
};

}  // namespace carom::render
