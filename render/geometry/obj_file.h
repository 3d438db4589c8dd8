// Meshes from Wavefront OBJ files.
#pragma once

#include <string>

#include "render/scene/scene_description.h"

namespace carom::render {

/// Positions, normals, uv and faces (polygons cut into triangles) of all groups together; materials
/// and colours are not read. Axes are taken as they stand in the file. Throws Error that names the
/// file: unreadable, not an OBJ file, too large (limits in obj_file.cpp), an index or number that
/// is wrong, or no face.
[[nodiscard]] MeshShape read_obj(const std::string& path);

}  // namespace carom::render
