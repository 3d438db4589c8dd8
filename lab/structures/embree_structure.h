// All shapes in one Embree scene.
#pragma once

#include <memory>
#include <span>

#include "render/acceleration/acceleration_structure.h"
#include "render/acceleration/shapes.h"

namespace carom::render {

class EmbreeDevice;
struct MeshEntry;

/// Returns an Embree device, with AVX2 if the processor has it. Throws Error.
[[nodiscard]] std::shared_ptr<const EmbreeDevice> make_embree_device();

/// The reference for HybridStructure: analytic shapes are user geometry, moving spheres have moving
/// bounds, and static meshes are triangles of the same scene. The hits are those of
/// HybridStructure, except that of two triangles at exactly the same distance either may be
/// reported.
class EmbreeStructure final : public AccelerationStructure {
  public:
    /// `shapes.meshes` is not used: the static meshes are given by `meshes` and must outlive this
    /// object. Throws Error.
    EmbreeStructure(std::shared_ptr<const EmbreeDevice> device, const ShapeSet& shapes,
                    std::span<const MeshEntry> meshes);
    ~EmbreeStructure() override;
    EmbreeStructure(const EmbreeStructure&) = delete;
    EmbreeStructure& operator=(const EmbreeStructure&) = delete;

    [[nodiscard]] bool closest_hit(const Ray& ray, Hit& hit) const override;
    [[nodiscard]] bool any_hit(const Ray& ray) const override;
    /// Memory of all scenes of the device.
    [[nodiscard]] std::size_t bytes() const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace carom::render
