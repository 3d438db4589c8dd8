// The shapes of one frame as input of acceleration structures: world axes, float, plain data.
// Object indices are below 2^31.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <Imath/ImathBox.h>

#include "render/acceleration/block_lists.h"
#include "render/geometry/affine.h"
#include "render/geometry/rigid_motion.h"

namespace carom::render {

class TriangleScene;  // triangle_scene.h
struct TriangleTree;  // triangle_tree.h

/// Any moving shape except a sphere and a mesh: it is tested in the axes of its unit shape at the
/// ray's time.
struct MovingShape {
    ShapeKind kind = ShapeKind::box;
    Affine unit_from_body;
    V3f parameters{0, 0, 0};  // see shape_list.h
    std::shared_ptr<const RigidMotion> motion;
    Imath::Box3f bounds;  // world axes, over the whole shutter
    std::uint32_t object = 0;

    /// Whether the shape is infinite, so that no bounding box exists.
    [[nodiscard]] bool is_infinite() const {
        return visit_shape(kind, false, [](auto shape) { return !decltype(shape)::kIsBounded; });
    }
};

/// One object that has a mesh. Rays are tested in the axes of the mesh.
struct MeshInstance {
    std::shared_ptr<const TriangleTree> mesh;   // its only object has the number 0
    std::optional<Affine> mesh_from_body;       // none: the mesh is in the axes of the body
    std::shared_ptr<const RigidMotion> motion;  // null: at rest, with the axes of the world
    Imath::Box3f bounds;                        // world axes, over the whole shutter
    std::uint32_t object = 0;
};

/// Everything that rays can hit in a frame.
struct ShapeSet {
    AnalyticBlocks blocks;
    std::vector<MovingShape> moving;
    std::vector<MeshInstance> instances;          // of meshes that move, or exist many times
    std::shared_ptr<const TriangleScene> meshes;  // all other meshes; may be null

    void add_sphere(const SphereSegment& sphere) {
        if (sphere.is_static()) {
            const auto [block, lane] = blocks.of<StaticSphere>().add(sphere.object);
            block.set(lane, sphere);
        } else {
            const auto [block, lane] = blocks.of<MovingSphere>().add(sphere.object);
            block.set(lane, sphere);
        }
    }
};

}  // namespace carom::render
