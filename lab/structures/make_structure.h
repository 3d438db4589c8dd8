// Makes the structures for comparison by their kind.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "lab/structures/acceleration_names.h"
#include "lab/structures/structure_options.h"
#include "render/acceleration/acceleration_structure.h"
#include "render/acceleration/mesh_entry.h"
#include "render/acceleration/shapes.h"
#include "render/acceleration/structure_maker.h"

namespace carom::render {

struct MadeStructure {
    std::unique_ptr<AccelerationStructure> structure;
    std::size_t bytes = 0;     // without the shapes themselves
    double build_seconds = 0;  // CPU time
};

/// A structure over all shapes and the triangles of `meshes`, which outlive it. `hybrid` and
/// `embree` neither count nor continue beyond the first hit. Throws Error.
[[nodiscard]] MadeStructure make_structure(AccelerationKind kind, const ShapeSet& shapes,
                                           std::span<const MeshEntry> meshes,
                                           const StructureOptions& options = {});

/// Whether its tests can be counted.
[[nodiscard]] bool can_count(AccelerationKind kind);

/// Whether its triangles are tested one by one, by StructureOptions::triangle_test.
[[nodiscard]] bool has_triangle_tests(AccelerationKind kind);

/// Whether the structure depends on this size.
[[nodiscard]] bool depends_on(AccelerationKind kind, VariedSize size);

/// Throws Error that lists the names if there is none.
[[nodiscard]] AccelerationKind structure_kind(const std::string& name);

/// "kdtree"
[[nodiscard]] std::string_view name_of(AccelerationKind kind);

/// "hybrid, embree, brute_force, ..."
[[nodiscard]] std::string structure_names();

/// Makes the structures of a kind.
[[nodiscard]] StructureMaker structure_maker(AccelerationKind kind);

/// NamedStructures of the laboratory.
[[nodiscard]] StructureMaker named_structure(const std::string& name);

}  // namespace carom::render
