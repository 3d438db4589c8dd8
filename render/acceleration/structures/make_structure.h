// The structures that the literature compares, by name.
#pragma once

#include <memory>
#include <span>

#include "render/acceleration/shapes.h"
#include "render/acceleration/structures/measured_structure.h"
#include "render/acceleration/structures/structure_options.h"
#include "render/acceleration/triangle_scene.h"
#include "render/scene/render_settings.h"

namespace carom::render {

/// Of any kind but `hybrid` and `embree`, over all shapes and the triangles of `meshes`, which
/// outlive it. All give the same bits.
[[nodiscard]] std::unique_ptr<MeasuredStructure> make_structure(AccelerationKind kind,
                                                                const ShapeSet& shapes,
                                                                std::span<const MeshEntry> meshes,
                                                                const StructureOptions& options);

}  // namespace carom::render
