#include "lab/structures/make_structure.h"

#include <algorithm>
#include <utility>

#include "core/cpu_time.h"
#include "core/error.h"
#include "lab/structures/bsp_tree.h"
#include "lab/structures/embree_structure.h"
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
#include "lab/structures/wide_bvh.h"
#include "render/acceleration/hybrid_structure.h"
#include "render/acceleration/triangle_scene.h"

namespace carom::render {

namespace {

using Measured = std::pair<std::unique_ptr<AccelerationStructure>, std::size_t>;

template <class Structure>
Measured with_bytes(std::unique_ptr<Structure> structure) {
    const std::size_t bytes = structure->bytes();
    return {std::move(structure), bytes};
}

ShapeSet with_meshes(ShapeSet shapes, std::span<const MeshEntry> meshes) {
    if (!meshes.empty()) {
        shapes.meshes = std::make_shared<TriangleScene>(meshes);
    }
    return shapes;
}

/// Other kinds than `embree`.
Measured make(AccelerationKind kind, const ShapeSet& shapes, std::span<const MeshEntry> meshes,
              const StructureOptions& options) {
    const auto over = [&]<class Index>() {
        return with_bytes(std::make_unique<PrimitiveStructure<Index>>(
            Primitives(shapes, meshes, options.triangle_test), options));
    };
    switch (kind) {
        case AccelerationKind::brute_force:
            return over.operator()<BruteForce>();
        case AccelerationKind::single_boxes:
            return over.operator()<SingleBoxes>();
        case AccelerationKind::grid:
            return over.operator()<UniformGrid>();
        case AccelerationKind::octree:
            return over.operator()<Octree<CubePlacement::centre>>();
        case AccelerationKind::octree_queue:
            return over.operator()<QueuedOctree>();
        case AccelerationKind::octree_loose:
            return over.operator()<Octree<CubePlacement::loose>>();
        case AccelerationKind::octree_enclosing:
            return over.operator()<Octree<CubePlacement::enclosing>>();
        case AccelerationKind::octree_overlapping:
            return over.operator()<Octree<CubePlacement::overlapping>>();
        case AccelerationKind::octree_cut:
            return over.operator()<Octree<CubePlacement::cut>>();
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
        case AccelerationKind::wide_bvh:
            return with_bytes(
                std::make_unique<WideBvh>(with_meshes(shapes, meshes), meshes, options));
        case AccelerationKind::hybrid:
        case AccelerationKind::embree:
            break;
    }
    return with_bytes(std::make_unique<HybridStructure>(with_meshes(shapes, meshes)));
}

}  // namespace

MadeStructure make_structure(AccelerationKind kind, const ShapeSet& shapes,
                             std::span<const MeshEntry> meshes, const StructureOptions& options) {
    const bool is_embree = kind == AccelerationKind::embree;
    const auto device = is_embree ? make_embree_device() : nullptr;  // no part of the building
    const double start = process_cpu_seconds();
    auto [structure, bytes] =
        is_embree ? with_bytes(std::make_unique<EmbreeStructure>(device, shapes, meshes))
                  : make(kind, shapes, meshes, options);
    return {std::move(structure), bytes, process_cpu_seconds() - start};
}

bool can_count(AccelerationKind kind) {
    return kind != AccelerationKind::hybrid && kind != AccelerationKind::embree;
}

bool has_triangle_tests(AccelerationKind kind) {
    return can_count(kind) && kind != AccelerationKind::wide_bvh;
}

bool depends_on(AccelerationKind kind, VariedSize size) {
    return std::ranges::find(kAccelerationNames, kind, &AccelerationName::kind)->size == size;
}

AccelerationKind structure_kind(const std::string& name) {
    const auto found = std::ranges::find(kAccelerationNames, name, &AccelerationName::name);
    if (found == kAccelerationNames.end()) {
        throw Error("unknown structure '" + name + "'; use one of " + structure_names());
    }
    return found->kind;
}

std::string_view name_of(AccelerationKind kind) {
    return std::ranges::find(kAccelerationNames, kind, &AccelerationName::kind)->name;
}

std::string structure_names() {
    std::string text;
    for (const AccelerationName& known : kAccelerationNames) {
        text += (text.empty() ? "" : ", ") + std::string(known.name);
    }
    return text;
}

StructureMaker structure_maker(AccelerationKind kind) {
    return [kind](const ShapeSet& shapes, std::span<const MeshEntry> meshes) {
        return make_structure(kind, shapes, meshes).structure;
    };
}

StructureMaker named_structure(const std::string& name) {
    const AccelerationKind kind = structure_kind(name);
    return kind == AccelerationKind::hybrid ? StructureMaker() : structure_maker(kind);
}

}  // namespace carom::render
