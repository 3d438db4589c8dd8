// Trees with eight children to a node over everything, triangles included.
#pragma once

#include "render/acceleration/analytic_tree.h"
#include "render/acceleration/analytic_tree_kernels.h"
#include "render/acceleration/primitives.h"
#include "render/acceleration/structures/measured_structure.h"
#include "render/acceleration/structures/triangle_tree.h"

namespace carom::render {

/// What `hybrid` uses for many analytic shapes, and another one for meshes: boxes are tested eight
/// at a time, shapes eight to a leaf. Tests are not counted.
class WideBvh final : public MeasuredStructure {
  public:
    WideBvh(const ShapeSet& shapes, std::span<const MeshEntry> meshes);

    [[nodiscard]] bool closest_hit(const Ray& ray, Hit& hit) const override;
    [[nodiscard]] bool any_hit(const Ray& ray) const override;
    [[nodiscard]] std::size_t bytes() const override;

  private:
    [[nodiscard]] bool meets_plane(const Ray& ray) const;

    Primitives planes_;
    AnalyticTree shapes_;
    TriangleTree triangles_;
    const AnalyticTreeKernels& shape_kernels_;
    const TriangleTreeKernels& triangle_kernels_;
};

}  // namespace carom::render
