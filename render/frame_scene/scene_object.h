// One object of a shot, checked and narrowed.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "render/acceleration/shapes.h"
#include "render/geometry/affine.h"
#include "render/geometry/triangle_mesh.h"
#include "render/scene/scene_description.h"

namespace carom::render {

/// World axes (of what follows a track: the body's) and those of the unit shape (shape_list.h).
struct UnitFrame {
    Affine unit_from_world;
    Affine world_from_unit;
};

struct SceneObject {
    std::string name;
    std::string track;  // empty: still
    ShapeKind kind = ShapeKind::ball;
    std::uint32_t material = kNoMaterial;
    std::optional<std::uint32_t> light;
    bool has_texture = false;
    bool is_round = false;        // a ball that is a sphere
    bool is_upright_box = false;  // a box whose axes are those of the world, in their order
    bool is_one_sided = false;    // a rectangle light
    V3f half_size{1, 1, 1};       // m: lengths of the unit shape's axes, so a ball's radii
    float reach = 1;              // as far from the body's origin the surface is at most, m
    UnitFrame frame;              // of analytic shapes
    Affine metres_from_world;     // object axes in metres, scaled; with a track: from the body's
    V3f profile{0, 0, 0};         // of the unit shape (shape_list.h)
    std::shared_ptr<const TriangleMesh> mesh;  // still: world axes; with a track: body axes

    [[nodiscard]] bool is_tracked() const { return !track.empty(); }
};

/// MeshShapes read from files, by path.
using MeshFiles = std::map<std::string, MeshShape>;

/// Throws Error that names the object.
[[nodiscard]] SceneObject make_object(const ObjectDescription& description, std::uint32_t material,
                                      bool has_texture, MeshFiles& files);

/// The object that stands for a light with an area; nothing for an environment.
[[nodiscard]] std::optional<SceneObject> make_light_object(const LightDescription& description,
                                                           std::uint32_t light);

/// The frame in world axes of a shape whose body is turned and placed as given.
[[nodiscard]] UnitFrame placed(const UnitFrame& in_body, const V3f& position,
                               const Imath::Quatf& world_from_body);

}  // namespace carom::render
