// Makes the structures for comparison by their kind.
#pragma once

#include <memory>
#include <span>

#include "render/acceleration/measured_structure.h"
#include "render/acceleration/shapes.h"
#include "render/acceleration/structure_factory.h"
#include "render/acceleration/structure_options.h"
#include "render/acceleration/triangle_scene.h"
#include "render/scene/render_settings.h"

namespace carom::render {

/// A render::StructureFactory of all kinds that the renderer does not make itself. All give the
/// same bits.
[[nodiscard]] std::unique_ptr<MeasuredStructure> make_structure(AccelerationKind kind,
                                                                const ShapeSet& shapes,
                                                                std::span<const MeshEntry> meshes,
                                                                const StructureOptions& options);

}  // namespace carom::render
