// Meshes from PLY files (Turk 1994, "The PLY polygon file format").
#pragma once

#include <string>

#include "render/scene/scene_description.h"

namespace carom::render {

/// Text and binary of either byte order. Of `vertex` the place (x, y, z), normal (nx, ny, nz) and
/// uv (s, t; u, v; texture_u, texture_v), of `face` its vertex_indices (polygons are cut into
/// triangles); all else is passed over. Throws Error that names the file: unreadable, not a PLY
/// file, too large (checked against the file's size before memory is taken), cut short, an index
/// or number that is wrong, or no face.
[[nodiscard]] MeshShape read_ply(const std::string& path);

/// Whether a file begins as PLY files do; false if it cannot be read.
[[nodiscard]] bool is_ply(const std::string& path);

}  // namespace carom::render
