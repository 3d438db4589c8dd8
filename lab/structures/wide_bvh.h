// The product's wide bounding volume hierarchies over all shapes, triangles included.
#pragma once

#include <memory>

#include "lab/structures/primitives.h"
#include "lab/structures/structure_options.h"
#include "lab/structures/test_counts.h"
#include "render/acceleration/hybrid_structure.h"
#include "render/acceleration/triangle_tree.h"

namespace carom::render {

/// The trees of HybridStructure for any number of shapes: boxes are tested eight at a time, and a
/// leaf has up to eight shapes. Shapes and boxes are counted by lanes in use. For that, rays go
/// through one tree of all triangles, whose hits are the same.
class WideBvh final : public AccelerationStructure {
  public:
    /// `shapes.meshes` has the triangles of `meshes`.
    WideBvh(const ShapeSet& shapes, std::span<const MeshEntry> meshes,
            const StructureOptions& options);
    ~WideBvh() override;

    [[nodiscard]] bool closest_hit(const Ray& ray, Hit& hit) const override;
    [[nodiscard]] bool any_hit(const Ray& ray) const override;
    [[nodiscard]] std::size_t bytes() const { return trees_.bytes(); }

  private:
    struct Counted;
    StructureOptions options_;
    HybridStructure trees_;
    std::unique_ptr<const Counted> counted_;  // null unless tests are counted
};

}  // namespace carom::render
