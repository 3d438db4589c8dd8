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
    enum class Kind {
        still_sphere,
        moving_sphere,
        box,
        mapped_ball,
        mapped_box,
        rectangle,
        triangle,
        disk,
        frustum,
        plane,
        moving,
        mesh_triangle
    };
    Kind kind = Kind::box;
    std::uint32_t index = 0;  // block * lanes + lane; of `moving`: in ShapeSet::moving; of meshes:
                              // in the list of meshes
    std::uint32_t object = 0;
    std::uint32_t number = 0;  // of a mesh's triangles
    MovingBounds bounds;       // of infinite planes without meaning
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
        return blocks_.still_spheres[sphere.index / kBlockLanes];
    }

  private:
    template <class Block, class Shape, class Bounds>
    void add(Primitive::Kind kind, const std::vector<Block>& blocks,
             const std::vector<Shape>& shapes, const Bounds& bounds);
    void add_meshes(std::span<const MeshEntry> meshes);

    const AnalyticKernels* kernels_ = nullptr;
    AnalyticBlocks blocks_;
    std::vector<MovingShape> moving_;
    std::vector<const TriangleMesh*> meshes_;
    std::vector<Primitive> bounded_;
    std::vector<Primitive> planes_;
};

}  // namespace carom::render
