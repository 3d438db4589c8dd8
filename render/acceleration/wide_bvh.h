// The product's wide bounding volume hierarchies over all shapes, triangles included.
#pragma once

#include "render/acceleration/analytic_tree.h"
#include "render/acceleration/analytic_tree_kernels.h"
#include "render/acceleration/measured_structure.h"
#include "render/acceleration/primitives.h"
#include "render/acceleration/shared_counts.h"
#include "render/acceleration/structure_options.h"
#include "render/acceleration/triangle_tree.h"

namespace carom::render {

/// The tree that HybridStructure uses for many analytic shapes, and a second one for meshes: boxes
/// are tested eight at a time, and a leaf has up to eight shapes. Shapes and boxes are counted by
/// lanes in use.
class WideBvh final : public MeasuredStructure {
  public:
    WideBvh(const ShapeSet& shapes, std::span<const MeshEntry> meshes,
            const StructureOptions& options);

    [[nodiscard]] bool closest_hit(const Ray& ray, Hit& hit) const override;
    [[nodiscard]] bool any_hit(const Ray& ray) const override;
    [[nodiscard]] std::size_t bytes() const override;
    [[nodiscard]] TestCounts counts() const override { return counts_.current(); }

  private:
    void find_closest_counted(const Ray& safe, RayKind kind, Hit& best) const;
    [[nodiscard]] bool find_any_counted(const Ray& safe) const;

    StructureOptions options_;
    Primitives planes_;
    AnalyticTree shapes_;
    TriangleTree triangles_;
    const AnalyticTreeKernels& shape_kernels_;
    const TriangleTreeKernels& triangle_kernels_;
    mutable SharedCounts counts_;
};

}  // namespace carom::render
