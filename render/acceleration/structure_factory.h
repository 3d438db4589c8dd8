// Structures that a program adds to those of the library.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "core/diagnostic.h"
#include "render/scene/render_settings.h"

namespace carom::render {

class MeasuredStructure;
struct MeshEntry;
struct ShapeSet;
struct StructureOptions;

/// Makes a structure over all shapes and the triangles of `meshes`, which outlive it. The library
/// calls it only for structures that it does not make itself.
using StructureFactory = std::unique_ptr<MeasuredStructure> (*)(AccelerationKind kind,
                                                                const ShapeSet& shapes,
                                                                std::span<const MeshEntry> meshes,
                                                                const StructureOptions& options);

/// The program that supplies a factory.
inline constexpr const char* kComparisonProgram = "carom-lab";

/// None if the library makes the structure itself, or if a factory is given (`factory` may be
/// null). The sentence names kComparisonProgram.
[[nodiscard]] std::optional<Diagnostic> find_problem(AccelerationKind kind,
                                                     StructureFactory factory);

}  // namespace carom::render
