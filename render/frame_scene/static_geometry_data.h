// The data of StaticGeometry. Internal to this folder.
#pragma once

#include <memory>
#include <vector>

#include "render/acceleration/analytic_tree.h"
#include "render/acceleration/shapes.h"
#include "render/acceleration/triangle_scene.h"
#include "render/frame_scene/scene_object.h"
#include "render/frame_scene/static_geometry.h"

namespace carom::render {

class EmbreeDevice;

struct StaticGeometry::Data {
    AccelerationKind acceleration = AccelerationKind::hybrid;
    StructureFactory factory = nullptr;          // for structures that the library does not make
    std::shared_ptr<const EmbreeDevice> device;  // null unless the structure is Embree
    std::vector<SceneObject> objects;            // those of the scene, then lights
    std::vector<std::optional<std::uint32_t>> object_of_light;
    std::vector<std::shared_ptr<const TriangleScene>> tracked_meshes;  // by object; may be null
    std::vector<MeshEntry> static_meshes;
    ShapeSet static_shapes;
    // For many static shapes: a tree over them, and those that the tree cannot hold.
    std::shared_ptr<const AnalyticTree> static_tree;
    ShapeSet outside_tree;
    double build_seconds = 0;  // CPU time of trees and scenes that frames share
};

/// Adds the shape of a static object.
void add_static_shape(ShapeSet& shapes, const SceneObject& object, std::uint32_t index,
                      const UnitFrame& frame);

}  // namespace carom::render
