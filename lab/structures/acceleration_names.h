// Names of acceleration structures in shots and on the command line.
#pragma once

#include <array>
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

struct AccelerationName {
    std::string_view name;
    AccelerationKind kind;
};

inline constexpr std::array<AccelerationName, 23> kAccelerationNames{
    {{"hybrid", AccelerationKind::hybrid},
     {"embree", AccelerationKind::embree},
     {"brute_force", AccelerationKind::brute_force},
     {"single_boxes", AccelerationKind::single_boxes},
     {"grid", AccelerationKind::grid},
     {"octree", AccelerationKind::octree},
     {"octree_queue", AccelerationKind::octree_queue},
     {"octree_loose", AccelerationKind::octree_loose},
     {"octree_enclosing", AccelerationKind::octree_enclosing},
     {"octree_overlapping", AccelerationKind::octree_overlapping},
     {"octree_cut", AccelerationKind::octree_cut},
     {"kdtree", AccelerationKind::kd_tree},
     {"kdtree_median", AccelerationKind::kd_tree_median},
     {"bsp", AccelerationKind::bsp_tree},
     {"rtree", AccelerationKind::r_tree},
     {"rtree_hilbert", AccelerationKind::r_tree_hilbert},
     {"rtree_cyclic", AccelerationKind::r_tree_cyclic},
     {"kay_kajiya", AccelerationKind::slabs},
     {"box_volumes", AccelerationKind::box_volumes},
     {"sphere_volumes", AccelerationKind::sphere_volumes},
     {"oriented_box_volumes", AccelerationKind::oriented_box_volumes},
     {"bvh", AccelerationKind::bvh},
     {"wide_bvh", AccelerationKind::wide_bvh}}};

}  // namespace carom::render
