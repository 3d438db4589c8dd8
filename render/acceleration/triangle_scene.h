// Triangle meshes in Embree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "render/acceleration/ray_batch.h"
#include "render/geometry/ray.h"
#include "render/geometry/triangle_mesh.h"

namespace carom::render {

class EmbreeDevice;

/// A mesh of a scene, and the object that its hits report.
struct MeshEntry {
    const TriangleMesh* mesh = nullptr;  // outlives the scene
    std::uint32_t object = 0;
};

/// A hierarchy over the triangles of meshes; immutable after construction and shared by threads.
/// The same meshes give the same hits, whatever the number of threads.
class TriangleScene {
  public:
    /// Throws Error with Embree's reason if the build fails (out of memory).
    TriangleScene(std::shared_ptr<const EmbreeDevice> device, std::span<const MeshEntry> meshes);
    ~TriangleScene();
    TriangleScene(const TriangleScene&) = delete;
    TriangleScene& operator=(const TriangleScene&) = delete;

    /// The nearest hit in (t_min, t_max) of a safe ray (safe_ray.h); without one, returns false and
    /// leaves `hit` untouched. Of triangles at exactly the same distance it always reports the same
    /// one, not necessarily the first.
    [[nodiscard]] bool closest_hit(const Ray& ray, Hit& hit) const;
    [[nodiscard]] bool any_hit(const Ray& ray) const;
    /// Those of the rays `asked` of a packet of safe rays for which `any_hit` is true.
    [[nodiscard]] PacketMask any_hits(const ShadowRayPacket& packet, PacketMask asked) const;

    /// See AccelerationStructure; for safe rays.
    void test_occlusion(const RayBatch& rays, float* t_max) const;

    /// Bytes used by all scenes of this Embree device.
    [[nodiscard]] std::size_t bytes() const;

    struct Data;
    [[nodiscard]] const Data& data() const { return *data_; }

  private:
    std::unique_ptr<Data> data_;
};

/// Returns an Embree device, with AVX2 if the processor has it. Throws Error.
[[nodiscard]] std::shared_ptr<const EmbreeDevice> make_embree_device();

}  // namespace carom::render
