// Meshes with fewer triangles, for the page's view.
#pragma once

#include <cstddef>

#include "pipeline/export/export_scene.h"

namespace carom::studio {

/// The triangles that a view can draw quickly even without a graphics card. With trails and handles
/// it stays below 60,000.
inline constexpr std::size_t kMostViewTriangles = 48'000;

/// Simplifies the meshes of parts and lamps until they have at most `most` triangles together, or
/// a further step would move a surface by more than 5 % of its part's size. Edges between materials
/// and open edges stay as they are; a scene with few triangles is not changed.
void lighten(pipeline::ExportScene& scene, std::size_t most = kMostViewTriangles);

}  // namespace carom::studio
