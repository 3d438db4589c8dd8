// One object of a shot, validated and converted to float.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "render/acceleration/shapes.h"
#include "render/geometry/affine.h"
#include "render/geometry/triangle_mesh.h"
#include "render/scene/scene_description.h"

namespace carom::render {

/// Maps between world axes (with a track: the body's) and those of the unit shape (shape_list.h).
struct UnitFrame {
    Affine unit_from_world;
    Affine world_from_unit;
};

struct SceneObject {
    std::string name;
    std::string track;  // empty: static
    ShapeKind kind = ShapeKind::sphere;
    std::uint32_t material = kNoMaterial;
    std::optional<std::uint32_t> light;
    bool has_texture = false;
    bool is_round = false;        // a sphere with three equal radii
    bool is_upright_box = false;  // a box along the world's axes, in their order
    bool is_one_sided = false;    // a flat light
    V3f half_size{1, 1, 1};       // m: lengths of the unit shape's axes, so a sphere's radii
    float bounding_radius = 1;    // largest distance of its surface from the body's origin, m
    UnitFrame frame;              // of analytic shapes, and of meshes with axes of their own
    Affine metres_from_world;     // object axes in metres, scaled; with a track: from the body's
    V3f parameters{0, 0, 0};      // of the unit shape (shape_list.h)
    std::shared_ptr<const TriangleMesh> mesh;  // static: world axes; with a track: body axes
    bool mesh_is_mapped = false;               // by `frame`, from axes of the mesh's own

    [[nodiscard]] bool is_tracked() const { return !track.empty(); }
    /// Whether its axes are those of the world; with a track: of the body.
    [[nodiscard]] bool has_axes_of_world() const {
        return metres_from_world.linear == Imath::M33f();
    }
    /// Of the mesh, in the axes of the world or the body.
    [[nodiscard]] V3f place_of_vertex(const V3f& vertex) const {
        return mesh_is_mapped ? frame.world_from_unit.point(vertex) : vertex;
    }
};

class MeshLibrary;  // mesh_library.h

/// Throws Error that names the object.
[[nodiscard]] SceneObject make_object(const ObjectDescription& description, std::uint32_t material,
                                      bool has_texture, MeshLibrary& meshes);

/// The object of a light with a surface; none for other lights.
[[nodiscard]] std::optional<SceneObject> make_light_object(const LightDescription& description,
                                                           std::uint32_t light);

[[nodiscard]] UnitFrame frame_of(const Mat44& world_from_unit);

/// The frame in world axes of a shape whose body has the given pose.
[[nodiscard]] UnitFrame placed(const UnitFrame& in_body, const V3f& position,
                               const Imath::Quatf& world_from_body);

}  // namespace carom::render
