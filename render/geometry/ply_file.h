// Reading of PLY files (Turk 1994, "The PLY polygon file format").
#pragma once

#include <string_view>

#include "render/geometry/mesh_file.h"
#include "render/geometry/mesh_text.h"

namespace carom::render {

/// Reads text and binary files of either byte order: from `vertex` the position (x, y, z), normal
/// (nx, ny, nz) and uv (s, t; u, v; texture_u, texture_v), from `face` its vertex_indices (polygons
/// are triangulated) and the uv of each corner (texcoord, as MeshLab writes them, which replace
/// those of the vertices), and the strips of `tristrips`; other properties are skipped. Throws
/// MeshRefusal, in a text with the line, if it is no PLY file, too large (checked against its size
/// before memory is allocated) or truncated, if an index or number is invalid, or if it has no
/// face.
[[nodiscard]] MeshReading read_ply(std::string_view text, MeshBlemishes& blemishes);

/// Whether a text begins like a PLY file.
[[nodiscard]] bool is_ply(std::string_view text);

}  // namespace carom::render
