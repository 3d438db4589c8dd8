// Names of acceleration structures in shots and on the command line.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace carom::render {

enum class AccelerationKind {
    hybrid,  // the renderer's own
    embree,
    brute_force,
    single_boxes,
    grid,
    octree,
    octree_queue,
    octree_loose,
    octree_enclosing,
    octree_overlapping,
    octree_cut,
    kd_tree,
    kd_tree_median,
    bsp_tree,
    r_tree,
    r_tree_hilbert,
    r_tree_cyclic,
    slabs,
    box_volumes,
    sphere_volumes,
    oriented_box_volumes,
    bvh,
    wide_bvh
};

/// A size that some structures leave open.
enum class VariedSize { leaf_capacity, node_capacity, grid_density };

struct AccelerationName {
    std::string_view name;
    AccelerationKind kind;
    std::optional<VariedSize> size{};  // the one that the structure leaves open
};

inline constexpr std::array<AccelerationName, 23> kAccelerationNames{
    {{"hybrid", AccelerationKind::hybrid},
     {"embree", AccelerationKind::embree},
     {"brute_force", AccelerationKind::brute_force},
     {"single_boxes", AccelerationKind::single_boxes},
     {"grid", AccelerationKind::grid, VariedSize::grid_density},
     {"octree", AccelerationKind::octree, VariedSize::leaf_capacity},
     {"octree_queue", AccelerationKind::octree_queue, VariedSize::leaf_capacity},
     {"octree_loose", AccelerationKind::octree_loose, VariedSize::leaf_capacity},
     {"octree_enclosing", AccelerationKind::octree_enclosing, VariedSize::leaf_capacity},
     {"octree_overlapping", AccelerationKind::octree_overlapping, VariedSize::leaf_capacity},
     {"octree_cut", AccelerationKind::octree_cut, VariedSize::leaf_capacity},
     {"kdtree", AccelerationKind::kd_tree, VariedSize::leaf_capacity},
     {"kdtree_median", AccelerationKind::kd_tree_median, VariedSize::leaf_capacity},
     {"bsp", AccelerationKind::bsp_tree, VariedSize::leaf_capacity},
     {"rtree", AccelerationKind::r_tree, VariedSize::node_capacity},
     {"rtree_hilbert", AccelerationKind::r_tree_hilbert, VariedSize::node_capacity},
     {"rtree_cyclic", AccelerationKind::r_tree_cyclic, VariedSize::node_capacity},
     {"kay_kajiya", AccelerationKind::slabs},
     {"box_volumes", AccelerationKind::box_volumes},
     {"sphere_volumes", AccelerationKind::sphere_volumes},
     {"oriented_box_volumes", AccelerationKind::oriented_box_volumes},
     {"bvh", AccelerationKind::bvh, VariedSize::leaf_capacity},
     {"wide_bvh", AccelerationKind::wide_bvh}}};

}  // namespace carom::render
