// Single shapes, as hierarchies and grids need them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lab/structures/triangle_test.h"
#include "render/acceleration/analytic_kernels.h"
#include "render/acceleration/instance_tree.h"
#include "render/acceleration/mesh_entry.h"
#include "render/acceleration/shape_bounds.h"
#include "render/acceleration/shapes.h"

namespace carom::render {

/// One shape: its place in the lists, and its bounds.
struct Primitive {
    static constexpr std::uint32_t kMoving = kLaneShapeCount;
    static constexpr std::uint32_t kMeshTriangle = kLaneShapeCount + 1;
    static constexpr std::uint32_t kInstance = kLaneShapeCount + 2;

    std::uint32_t shape = 0;  // kLaneShape or one of these
    std::uint32_t index = 0;  // in that shape's list, that of ShapeSet, or the list of meshes
    std::uint32_t object = 0;
    std::uint32_t number = 0;  // the triangle in its mesh
    MovingBounds bounds;       // meaningless for infinite shapes
};

/// All shapes of a frame. A sphere with impacts is one primitive for each segment of its path, an
/// instance of a mesh is one primitive.
class Primitives {
  public:
    /// Infinite planes have a list of their own; the triangles of `meshes` come last. The triangles
    /// in `shapes.meshes` are left out. The meshes must outlive this object.
    /// `triangle_test` may be empty.
    explicit Primitives(const ShapeSet& shapes, std::span<const MeshEntry> meshes = {},
                        const TriangleTestMaker& triangle_test = {});

    [[nodiscard]] std::span<const Primitive> bounded() const { return bounded_; }
    [[nodiscard]] std::span<const Primitive> planes() const { return planes_; }

    /// The nearest hit of one primitive in (ray.t_min, ray.t_max) of a safe ray; without one,
    /// returns false and leaves `hit` untouched. Analytic shapes give the same bits as
    /// HybridStructure.
    [[nodiscard]] bool closest(const Primitive& primitive, const Ray& ray, Hit& hit) const;

    /// Replaces `best` by the nearest hit of an infinite plane if that is nearer, or equally near
    /// and of a lower object. A `best` without an object stands for the end of the ray.
    void find_closest_plane(const Ray& ray, Hit& best) const;
    /// Index of the first plane in the list that the ray hits; the number of planes if it hits
    /// none.
    [[nodiscard]] std::size_t first_plane_hit(const Ray& ray) const;

    /// The corners of a mesh triangle.
    [[nodiscard]] std::array<V3f, 3> corners(const Primitive& triangle) const;
    /// The lists to which Primitive::index refers, except for moving shapes and meshes.
    [[nodiscard]] const AnalyticBlocks& blocks() const { return blocks_; }

  private:
    template <class Shape>
    void add(const BlockList<Shape>& list);
    void add_meshes(std::span<const MeshEntry> meshes);

    const AnalyticKernels* kernels_ = nullptr;
    AnalyticBlocks blocks_;
    std::vector<MovingShape> moving_;
    std::vector<InstanceTree> instances_;  // each of one
    std::vector<const TriangleMesh*> meshes_;
    std::shared_ptr<const TriangleTest> triangle_test_;  // may be null
    std::vector<std::size_t> first_triangle_;            // of each mesh, for it
    std::vector<Primitive> bounded_;
    std::vector<Primitive> planes_;
};

}  // namespace carom::render
