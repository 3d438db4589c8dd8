// The shapes of one frame as input of acceleration structures: world axes, float, plain data.
// Object indices are below 2^31.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <Imath/ImathBox.h>

#include "render/acceleration/block_lists.h"
#include "render/geometry/affine.h"
#include "render/geometry/rigid_motion.h"

namespace carom::render {

class TriangleScene;

/// Any moving shape except a sphere: it is tested in the axes of its unit shape (meshes: of the
/// body) at the ray's time.
struct MovingShape {
    ShapeKind kind = ShapeKind::box;
    Affine unit_from_body;
    V3f parameters{0, 0, 0};  // see shape_list.h
    std::shared_ptr<const RigidMotion> motion;
    std::shared_ptr<const TriangleScene> mesh;  // in body axes, object indices 0
    Imath::Box3f bounds;                        // world axes, over the whole shutter
    std::uint32_t object = 0;

    /// Whether the shape is infinite, so that no bounding box exists.
    [[nodiscard]] bool is_infinite() const {
        return visit_shape(kind, false, [](auto shape) { return !decltype(shape)::kIsBounded; });
    }
};

/// Everything that rays can hit in a frame.
struct ShapeSet {
    AnalyticBlocks blocks;
    std::vector<MovingShape> moving;
    std::shared_ptr<const TriangleScene> meshes;  // all static meshes; may be null

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
