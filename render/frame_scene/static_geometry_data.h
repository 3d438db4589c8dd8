// What StaticGeometry holds. For the .cpp files of this folder only.
#pragma once

#include <memory>
#include <vector>

#include "render/acceleration/analytic_tree.h"
#include "render/acceleration/shapes.h"
#include "render/acceleration/triangle_scene.h"
#include "render/frame_scene/scene_object.h"
#include "render/frame_scene/static_geometry.h"

namespace carom::render {

struct StaticGeometry::Data {
    AccelerationKind acceleration = AccelerationKind::hybrid;
    StructureFactory factory = nullptr;          // for structures that the library does not make
    std::shared_ptr<const EmbreeDevice> device;  // null if there is no mesh and no need
    std::vector<SceneObject> objects;            // the scene's, then lights
    std::vector<std::optional<std::uint32_t>> object_of_light;
    std::vector<std::shared_ptr<const TriangleScene>> tracked_meshes;  // by object, else null
    std::vector<MeshEntry> still_meshes;
    ShapeSet still;  // all that never moves
    // Where that is much: a tree over it, and what is not in the tree.
    std::shared_ptr<const AnalyticTree> still_tree;
    ShapeSet beside_tree;
    double build_seconds = 0;  // CPU time of trees and scenes that frames share
};

/// Adds a still object's shape where it stands.
void add_still_shape(ShapeSet& shapes, const SceneObject& object, std::uint32_t index,
                     const UnitFrame& frame);

}  // namespace carom::render
