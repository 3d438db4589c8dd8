// Reading of Wavefront OBJ files (Wavefront, "Advanced Visualizer Manual", appendix B1).
#pragma once

#include <string_view>
#include <vector>

#include "render/geometry/mesh_file.h"

namespace carom::render {

/// Reads positions, normals, uv and faces (polygons are triangulated) of all groups together, and
/// which faces have which material; material libraries are not opened. Axes are kept as they are in
/// the file. Faces may refer to vertices that come after them. Throws MeshRefusal (mesh_text.h)
/// with the line if the text is not an OBJ file or too large (limits in triangle_mesh.h), if an
/// index or number is invalid, or if there is no face.
[[nodiscard]] MeshReading read_obj(std::string_view text);

/// The same for each material (read_mesh_parts in mesh_file.h).
[[nodiscard]] std::vector<MeshReading> read_obj_parts(std::string_view text);

}  // namespace carom::render
