// Reading of mesh files.
#pragma once

#include <string>

#include "render/scene/scene_description.h"

namespace carom::render {

/// Reads a PLY file, recognised by its first line, or an OBJ file. Throws Error that names the file
/// and the problem (obj_file.h, ply_file.h). All numbers returned are finite, also as floats;
/// invalid normals and uv become zero.
[[nodiscard]] MeshShape read_mesh(const std::string& path);

}  // namespace carom::render
