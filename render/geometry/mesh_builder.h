// From the faces of a mesh file to triangles. Internal to this folder.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/geometry/mesh_file.h"
#include "render/geometry/mesh_text.h"

namespace carom::render {

inline constexpr std::uint32_t kNoIndex = 0xffff'ffff;

/// A corner of a face: its position, uv and normal as entries of the lists of the file, counted
/// from 0, or kNoIndex.
using MeshCorner = std::array<std::uint32_t, 3>;

/// Faces whose corners have a position, and a uv and a normal of their own.
struct MeshFaces {
    struct Face {
        std::uint32_t corner_count = 0;
        std::uint32_t material = MeshReading::kNoMaterial;
        std::size_t line = 0;  // of the file; 0: unknown
    };

    std::vector<Vec3> points;
    std::vector<Vec2> uv;
    std::vector<Vec3> normals;
    std::vector<MeshCorner> corners;  // of one face after another
    std::vector<Face> faces;
};

/// "a face refers to normal 7, but ...". `field`: as in MeshCorner; `index`: as it was written.
[[nodiscard]] std::string reference_problem(std::size_t field, std::string_view index,
                                            std::size_t count);

/// Fills in `reading.mesh` and `reading.triangle_materials`. Corners with equal position, uv and
/// normal share a vertex. uv and normals are used only if every corner has them. Throws MeshRefusal
/// if a corner refers to something that does not exist. `material`: of the faces that are taken;
/// none: all faces.
void build_mesh(const MeshFaces& faces, MeshReading& reading, MeshBlemishes& blemishes,
                std::optional<std::uint32_t> material = std::nullopt);

}  // namespace carom::render
