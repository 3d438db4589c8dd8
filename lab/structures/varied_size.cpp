#include "lab/structures/varied_size.h"

namespace carom::render {

bool depends_on(AccelerationKind kind, VariedSize size) {
    switch (kind) {
        case AccelerationKind::grid:
            return size == VariedSize::grid_density;
        case AccelerationKind::octree:
        case AccelerationKind::octree_queue:
        case AccelerationKind::octree_loose:
        case AccelerationKind::octree_enclosing:
        case AccelerationKind::octree_overlapping:
        case AccelerationKind::octree_cut:
        case AccelerationKind::kd_tree:
        case AccelerationKind::kd_tree_median:
        case AccelerationKind::bsp_tree:
        case AccelerationKind::bvh:
            return size == VariedSize::leaf_capacity;
        case AccelerationKind::r_tree:
        case AccelerationKind::r_tree_hilbert:
        case AccelerationKind::r_tree_cyclic:
            return size == VariedSize::node_capacity;
        case AccelerationKind::hybrid:
        case AccelerationKind::embree:
        case AccelerationKind::brute_force:
        case AccelerationKind::single_boxes:
        case AccelerationKind::slabs:
        case AccelerationKind::box_volumes:
        case AccelerationKind::sphere_volumes:
        case AccelerationKind::oriented_box_volumes:
        case AccelerationKind::wide_bvh:
            break;
    }
    return false;
}

StructureSizes with_size(VariedSize size, double value) {
    StructureSizes sizes;
    switch (size) {
        case VariedSize::leaf_capacity:
            sizes.leaf_capacity = static_cast<int>(value);
            break;
        case VariedSize::node_capacity:
            sizes.node_capacity = static_cast<int>(value);
            break;
        case VariedSize::grid_density:
            sizes.grid_density = value;
            break;
    }
    return sizes;
}

}  // namespace carom::render
