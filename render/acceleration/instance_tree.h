// Objects with meshes in a tree: one tree of triangles for any number of equal meshes.
#pragma once

#include <cstddef>
#include <vector>

#include <Imath/ImathBox.h>

#include "render/acceleration/shapes.h"
#include "render/acceleration/triangle_tree.h"

namespace carom::render {

/// A tree over instances, whose leaves have trees of their own.
struct InstanceTree {
    WideTree tree;
    Imath::Box3f bounds;
    std::vector<MeshInstance> instances;  // by leaf
};

[[nodiscard]] InstanceTree make_instance_tree(const std::vector<MeshInstance>& instances);

/// Memory of the trees, each counted once.
[[nodiscard]] std::size_t bytes_of(const InstanceTree& tree);

}  // namespace carom::render
