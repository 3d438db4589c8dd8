// Reading of PLY files (Turk 1994, "The PLY polygon file format").
#pragma once

#include <string>

#include "render/scene/scene_description.h"

namespace carom::render {

/// Reads text and binary files of either byte order: from `vertex` the position (x, y, z), normal
/// (nx, ny, nz) and uv (s, t; u, v; texture_u, texture_v), from `face` its vertex_indices (polygons
/// are triangulated); other properties are skipped. Throws Error that names the file if it is
/// unreadable, not a PLY file, too large (checked against the file's size before memory is
/// allocated) or truncated, if an index or number is invalid, or if it has no face.
[[nodiscard]] MeshShape read_ply(const std::string& path);

/// Whether a file begins like a PLY file; false if it cannot be read.
[[nodiscard]] bool is_ply(const std::string& path);

}  // namespace carom::render
