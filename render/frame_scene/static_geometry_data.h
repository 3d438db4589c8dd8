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

struct StaticGeometry::Data {
    StructureMaker maker;              // empty: the frames have a HybridStructure
    std::vector<SceneObject> objects;  // those of the scene, then lights
    std::vector<std::optional<std::uint32_t>> object_of_light;
    std::vector<MeshEntry> static_meshes;  // those that are not among the instances
    ShapeSet static_shapes;
    std::vector<MeshInstance> tracked_instances;  // without motion and bounds
    // For many static shapes: a tree over them, and those that the tree cannot hold.
    std::shared_ptr<const AnalyticTree> static_tree;
    ShapeSet outside_tree;
};

/// Adds the shape of a static object, which is not a mesh.
void add_static_shape(ShapeSet& shapes, const SceneObject& object, std::uint32_t index,
                      const UnitFrame& frame);

}  // namespace carom::render
