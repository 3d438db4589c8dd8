// One object of a shot, checked and narrowed. For the .cpp files of this folder only.
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

enum class ShapeKind { ball, box, rectangle, plane, mesh };

/// World axes and those of the unit shape (shapes.h).
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
    V3f half_size{1, 1, 1};       // body axes, m, scaled; a ball's radii, 1 for planes and meshes
    float reach = 1;              // largest distance of the surface from the body's origin, m
    UnitFrame frame;              // of still analytic shapes
    Affine body_from_world;       // of still shapes: object axes, metres
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

/// The frame of a shape with those half sizes that is turned and placed as given.
[[nodiscard]] UnitFrame unit_frame(const V3f& half_size, const V3f& position,
                                   const Imath::Quatf& world_from_body);

}  // namespace carom::render
