// Everything in one scene of Embree.
#pragma once

#include <memory>
#include <span>

#include "render/acceleration/measured_structure.h"
#include "render/acceleration/shapes.h"

namespace carom::render {

class EmbreeDevice;
struct MeshEntry;

/// The yardstick for the hybrid structure: analytic shapes are user geometry, moving spheres with
/// bounds that move; still meshes are triangles of the same scene. Same hits as HybridStructure,
/// except which of two triangles at the very same distance is named.
class EmbreeStructure final : public MeasuredStructure {
  public:
    /// `shapes.meshes` is not used: the still meshes are given themselves and outlive this.
    /// Throws Error.
    EmbreeStructure(std::shared_ptr<const EmbreeDevice> device, const ShapeSet& shapes,
                    std::span<const MeshEntry> meshes);
    ~EmbreeStructure() override;
    EmbreeStructure(const EmbreeStructure&) = delete;
    EmbreeStructure& operator=(const EmbreeStructure&) = delete;

    [[nodiscard]] bool closest_hit(const Ray& ray, Hit& hit) const override;
    [[nodiscard]] bool any_hit(const Ray& ray) const override;
    [[nodiscard]] std::size_t bytes() const override;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace carom::render
