// Reading of Wavefront OBJ files.
#pragma once

#include <string>

#include "render/scene/scene_description.h"

namespace carom::render {

/// Positions, normals, uv and faces (polygons are triangulated) of all groups together; materials
/// and colours are not read. Axes are kept as they are in the file. Throws Error that names the
/// file if it is unreadable, not an OBJ file or too large (limits in obj_file.cpp), if an index or
/// number is invalid, or if it has no face.
[[nodiscard]] MeshShape read_obj(const std::string& path);

}  // namespace carom::render
