// The seam for programs that compare acceleration structures. The renderer itself has one, `hybrid`
// (hybrid_structure.h).
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

namespace carom::render {

class AccelerationStructure;
struct MeshEntry;
struct ShapeSet;

/// The name of the renderer's own structure in RenderSettings::acceleration.
inline constexpr const char* kOwnStructure = "hybrid";

/// Makes the structure of each frame instead of the renderer, over all shapes and the triangles of
/// `meshes`, which outlive it.
using StructureMaker = std::function<std::unique_ptr<AccelerationStructure>(
    const ShapeSet& shapes, std::span<const MeshEntry> meshes)>;

/// The makers of a program that has structures of its own, by the name in
/// RenderSettings::acceleration; empty for kOwnStructure. Throws Error if there is none.
using NamedStructures = StructureMaker (*)(const std::string& name);

/// `structures` may be null.
[[nodiscard]] inline StructureMaker structure_maker(NamedStructures structures,
                                                    const std::string& name) {
    return structures != nullptr ? structures(name) : StructureMaker();
}

}  // namespace carom::render
