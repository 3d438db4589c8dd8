// Triangles behind Embree.
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

/// A mesh that is part of a scene, and the object that its hits name.
struct MeshEntry {
    const TriangleMesh* mesh = nullptr;  // outlives the scene
    std::uint32_t object = 0;
};

/// A hierarchy over the triangles of meshes, built once; immutable and shared by threads. The same
/// meshes give the same hits, whatever the number of threads.
class TriangleScene {
  public:
    /// Throws Error with Embree's reason if it fails (out of memory).
    TriangleScene(std::shared_ptr<const EmbreeDevice> device, std::span<const MeshEntry> meshes);
    ~TriangleScene();
    TriangleScene(const TriangleScene&) = delete;
    TriangleScene& operator=(const TriangleScene&) = delete;

    /// The nearest hit in (t_min, t_max) of a safe ray (safe_ray.h); false and an untouched `hit`
    /// if there is none. Of triangles met at the very same distance it is always the same one, not
    /// necessarily the first.
    [[nodiscard]] bool closest_hit(const Ray& ray, Hit& hit) const;
    [[nodiscard]] bool any_hit(const Ray& ray) const;
    /// The rays `asked` for of a fan of safe rays for which `any_hit` is true.
    [[nodiscard]] FanMask any_hits(const RayFan& fan, FanMask asked) const;

    /// As AccelerationStructure's, for safe rays.
    void drop_blocked(const RayBatch& rays, float* reach) const;

    /// What it takes with everything else of its device.
    [[nodiscard]] std::size_t bytes() const;

    struct Data;
    [[nodiscard]] const Data& data() const { return *data_; }

  private:
    std::unique_ptr<Data> data_;
};

/// A device of Embree, with AVX2 where the processor has it. Throws Error.
[[nodiscard]] std::shared_ptr<const EmbreeDevice> make_embree_device();

}  // namespace carom::render
