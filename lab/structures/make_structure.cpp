#include "lab/structures/make_structure.h"

#include "core/error.h"
#include "lab/structures/bsp_tree.h"
#include "lab/structures/kd_tree.h"
#include "lab/structures/linear_structures.h"
#include "lab/structures/median_kd_tree.h"
#include "lab/structures/octree.h"
#include "lab/structures/oriented_box_volumes.h"
#include "lab/structures/primitive_structure.h"
#include "lab/structures/r_tree.h"
#include "lab/structures/sah_bvh.h"
#include "lab/structures/slab_volumes.h"
#include "lab/structures/sphere_volumes.h"
#include "lab/structures/uniform_grid.h"
#include "lab/structures/volume_tree.h"

namespace carom::render {

std::unique_ptr<MeasuredStructure> make_structure(AccelerationKind kind, const ShapeSet& shapes,
                                                  std::span<const MeshEntry> meshes,
                                                  const StructureOptions& options) {
    const auto over = [&]<class Index>() -> std::unique_ptr<MeasuredStructure> {
        return std::make_unique<PrimitiveStructure<Index>>(Primitives(shapes, meshes), options);
    };
    switch (kind) {
        case AccelerationKind::brute_force:
            return over.operator()<BruteForce>();
        case AccelerationKind::single_boxes:
            return over.operator()<SingleBoxes>();
        case AccelerationKind::grid:
            return over.operator()<UniformGrid>();
        case AccelerationKind::octree:
            return over.operator()<Octree<Placement::centre>>();
        case AccelerationKind::octree_queue:
            return over.operator()<QueuedOctree>();
        case AccelerationKind::octree_loose:
            return over.operator()<Octree<Placement::loose>>();
        case AccelerationKind::octree_enclosing:
            return over.operator()<Octree<Placement::enclosing>>();
        case AccelerationKind::octree_overlapping:
            return over.operator()<Octree<Placement::overlapping>>();
        case AccelerationKind::octree_cut:
            return over.operator()<Octree<Placement::cut>>();
        case AccelerationKind::kd_tree:
            return over.operator()<KdTree>();
        case AccelerationKind::kd_tree_median:
            return over.operator()<MedianKdTree>();
        case AccelerationKind::bsp_tree:
            return over.operator()<BspTree>();
        case AccelerationKind::r_tree:
            return over.operator()<RTree<Packing::sort_tile_recursive>>();
        case AccelerationKind::r_tree_hilbert:
            return over.operator()<RTree<Packing::hilbert>>();
        case AccelerationKind::r_tree_cyclic:
            return over.operator()<RTree<Packing::cyclic>>();
        case AccelerationKind::slabs:
            return over.operator()<VolumeTree<SlabVolumes<7>>>();
        case AccelerationKind::box_volumes:
            return over.operator()<VolumeTree<SlabVolumes<3>>>();
        case AccelerationKind::sphere_volumes:
            return over.operator()<VolumeTree<SphereVolumes>>();
        case AccelerationKind::oriented_box_volumes:
            return over.operator()<VolumeTree<OrientedBoxVolumes>>();
        case AccelerationKind::bvh:
            return over.operator()<SahBvh>();
        case AccelerationKind::hybrid:
        case AccelerationKind::embree:
        case AccelerationKind::wide_bvh:
            break;
    }
    throw Error("the renderer itself makes this structure");
}

}  // namespace carom::render
