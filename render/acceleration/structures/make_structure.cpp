#include "render/acceleration/structures/make_structure.h"

#include "core/error.h"
#include "render/acceleration/structures/brute_force.h"
#include "render/acceleration/structures/bsp_tree.h"
#include "render/acceleration/structures/kd_tree.h"
#include "render/acceleration/structures/median_kd_tree.h"
#include "render/acceleration/structures/octree.h"
#include "render/acceleration/structures/primitive_structure.h"
#include "render/acceleration/structures/r_tree.h"
#include "render/acceleration/structures/sah_bvh.h"
#include "render/acceleration/structures/slab_hierarchy.h"
#include "render/acceleration/structures/uniform_grid.h"
#include "render/acceleration/structures/wide_bvh.h"

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
        case AccelerationKind::grid:
            return over.operator()<UniformGrid>();
        case AccelerationKind::octree:
            return over.operator()<Octree>();
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
        case AccelerationKind::slabs:
            return over.operator()<SlabHierarchy>();
        case AccelerationKind::bvh:
            return over.operator()<SahBvh>();
        case AccelerationKind::wide_bvh:
            return std::make_unique<WideBvh>(shapes, meshes, options);
        case AccelerationKind::hybrid:
        case AccelerationKind::embree:
            break;
    }
    throw Error("this structure is not one of those that are made so");
}

}  // namespace carom::render
