#include "render/frame_scene/flat_faces.h"

#include <utility>

#include "render/frame_scene/static_geometry_data.h"

namespace carom::render {
namespace {

using Triangle = std::array<V3f, 3>;

/// Faces of the unit shape, mapped to the axes of the body or the world.
class Faces {
  public:
    explicit Faces(const UnitFrame& frame) : frame_(frame) {}

    /// `front`: the outward normal on the unit shape.
    void add(const V3f& a, const V3f& b, const V3f& c, const V3f& front) {
        const Affine& map = frame_.world_from_unit;
        Triangle t{map.point(a), map.point(b), map.point(c)};
        const V3f normal = Affine::normal(front, frame_.unit_from_world);
        if ((t[1] - t[0]).cross(t[2] - t[0]).dot(normal) < 0) {
            std::swap(t[1], t[2]);
        }
        triangles_.push_back(t);
    }
    /// The parallelogram around `centre` with these half edges.
    void add_square(const V3f& centre, const V3f& u, const V3f& v, const V3f& front) {
        add(centre - u - v, centre + u - v, centre + u + v, front);
        add(centre - u - v, centre + u + v, centre - u + v, front);
    }
    [[nodiscard]] std::vector<Triangle> take() { return std::move(triangles_); }

  private:
    UnitFrame frame_;
    std::vector<Triangle> triangles_;
};

std::vector<Triangle> of_mesh(const SceneObject& object) {
    const TriangleMesh& mesh = *object.mesh;
    const bool is_mirrored =
        object.mesh_is_mapped && object.frame.world_from_unit.linear.determinant() < 0;
    std::vector<Triangle> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const auto& corners : mesh.triangles) {
        Triangle triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            triangle[k] = object.place_of_vertex(mesh.vertices[corners[k]]);
        }
        if (is_mirrored) {
            std::swap(triangle[1], triangle[2]);
        }
        triangles.push_back(triangle);
    }
    return triangles;
}

}  // namespace

std::vector<Triangle> flat_faces(const StaticGeometry& geometry, std::uint32_t index) {
    const SceneObject& object = geometry.data().objects[index];
    const V3f x(1, 0, 0);
    const V3f y(0, 1, 0);
    const V3f z(0, 0, 1);
    Faces faces(object.frame);
    if (object.kind == ShapeKind::mesh) {
        return of_mesh(object);
    }
    if (object.kind == ShapeKind::rectangle) {
        faces.add_square(V3f(0, 0, 0), x, y, z);
    } else if (object.kind == ShapeKind::triangle) {
        faces.add(V3f(0, 0, 0), x, y, z);
    } else if (object.kind == ShapeKind::box) {
        for (const float side : {1.0f, -1.0f}) {
            faces.add_square(x * side, y, z, x * side);
            faces.add_square(y * side, z, x, y * side);
            faces.add_square(z * side, x, y, z * side);
        }
    }
    return faces.take();
}

}  // namespace carom::render
