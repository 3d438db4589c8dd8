// Reading of mesh files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "render/scene/scene_description.h"

namespace carom::render {

/// A sentence about a mesh file.
struct MeshRemark {
    std::size_t line = 0;  // from 1; 0: the file as a whole
    std::string sentence;  // without the name of the file
};

/// What a mesh file holds.
struct MeshReading {
    MeshShape mesh;                      // no triangle if there are problems
    std::vector<MeshRemark> problems;    // why it cannot be used
    std::vector<MeshRemark> warnings;    // what was left out, such as normals that are no numbers
    std::vector<std::string> materials;  // names in an OBJ file, in the order of their first use
    std::vector<std::uint32_t> triangle_materials;  // of each triangle, or kNoMaterial; or empty
    std::vector<std::string> libraries;             // what follows `mtllib` in an OBJ file
    std::vector<std::string> pictures;  // what follows `comment TextureFile` in a PLY file

    static constexpr std::uint32_t kNoMaterial = 0xffff'ffff;
};

/// Reads a PLY file, recognised by its first line, or an OBJ file (obj_file.h, ply_file.h). All
/// numbers returned are finite, also as floats; invalid normals and uv become zero. Does not throw
/// because of what the file is or holds.
[[nodiscard]] MeshReading read_mesh_file(const std::string& path);

/// The faces of each material of a file as a mesh of its own, in the order of `materials`, and then
/// those without a material, if there are any. uv and normals of a part are used if all of its
/// corners have them. One reading with problems if the file cannot be used.
[[nodiscard]] std::vector<MeshReading> read_mesh_parts(const std::string& path);

/// The mesh of a file; throws Error that names the file and its first problem.
[[nodiscard]] MeshShape read_mesh(const std::string& path);

/// "'mesh.obj': line 5: SENTENCE", or without a line "'mesh.obj': SENTENCE".
[[nodiscard]] std::string text_of(const std::string& path, const MeshRemark& remark);

}  // namespace carom::render
