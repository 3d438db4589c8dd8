// Meshes from files.
#pragma once

#include <string>

#include "render/scene/scene_description.h"

namespace carom::render {

/// A PLY file by its first line, else an OBJ file. Throws Error that names the file and what is
/// wrong (obj_file.h, ply_file.h). Every number is finite, in float, too; a normal or uv that was
/// not has become zero.
[[nodiscard]] MeshShape read_mesh(const std::string& path);

}  // namespace carom::render
