// Shapes one at a time, as hierarchies and grids ask for them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/acceleration/analytic_kernels.h"
#include "render/acceleration/shape_bounds.h"
#include "render/acceleration/shapes.h"
#include "render/acceleration/triangle_scene.h"

namespace carom::render {

/// One of them: where it is, and its bounds.
struct Primitive {
    static constexpr std::uint32_t kMoving = kLaneShapeCount;
    static constexpr std::uint32_t kMeshTriangle = kLaneShapeCount + 1;

    std::uint32_t shape = 0;  // kLaneShape, kMoving or kMeshTriangle
    std::uint32_t index = 0;  // in that shape's list; in ShapeSet::moving; in the list of meshes
    std::uint32_t object = 0;
    std::uint32_t number = 0;  // of a mesh's triangles
    MovingBounds bounds;       // of infinite shapes without meaning
};

/// All shapes of a frame. A sphere with impacts is one primitive for each stretch of its path.
class Primitives {
  public:
    /// Infinite planes come in a list of their own, the triangles of `meshes` last; those of
    /// `shapes.meshes` are left out. The meshes outlive the list.
    explicit Primitives(const ShapeSet& shapes, std::span<const MeshEntry> meshes = {});

    [[nodiscard]] std::span<const Primitive> bounded() const { return bounded_; }
    [[nodiscard]] std::span<const Primitive> planes() const { return planes_; }

    /// The nearest hit of one in (ray.t_min, ray.t_max) of a safe ray; false and an untouched `hit`
    /// if there is none. Analytic shapes give the bits that HybridStructure gives.
    [[nodiscard]] bool closest(const Primitive& primitive, const Ray& ray, Hit& hit) const;

    /// Replaces `best` by the nearest hit of an infinite plane that is nearer, or as near and of a
    /// lower object. A `best` without an object ends where the ray does.
    void find_closest_plane(const Ray& ray, Hit& best) const;
    /// Index of the first plane that the ray meets; their number if it meets none.
    [[nodiscard]] std::size_t first_plane_met(const Ray& ray) const;

    /// Corners of a mesh's triangle.
    [[nodiscard]] std::array<V3f, 3> corners(const Primitive& triangle) const;
    /// Of a sphere that stands still.
    [[nodiscard]] const StillSphereBlock& sphere_block(const Primitive& sphere) const {
        return blocks_.of<StillSphere>().blocks[sphere.index / kBlockLanes];
    }

  private:
    template <class Shape>
    void add(const BlockList<Shape>& list);
    void add_meshes(std::span<const MeshEntry> meshes);

    const AnalyticKernels* kernels_ = nullptr;
    AnalyticBlocks blocks_;
    std::vector<MovingShape> moving_;
    std::vector<const TriangleMesh*> meshes_;
    std::vector<Primitive> bounded_;
    std::vector<Primitive> planes_;
};

}  // namespace carom::render
