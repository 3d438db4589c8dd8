// Triangle meshes in float, ready to be traced.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/geometry/mesh_arrays.h"
#include "render/geometry/ray.h"
#include "render/scene/scene_description.h"

namespace carom::render {

/// Indexed triangles; corners counter-clockwise seen from outside. `normals` and `uv` have one
/// entry per vertex, or none. Every index is valid and every number finite.
struct TriangleMesh {
    std::vector<V3f> vertices;
    std::vector<V3f> normals;  // unit, or 0 without an adjacent triangle that has an area
    std::vector<V2f> uv;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Valid as long as the mesh is.
[[nodiscard]] inline MeshArrays arrays_of(const TriangleMesh& mesh) {
    static_assert(sizeof(V3f) == 3 * sizeof(float) && sizeof(V2f) == 2 * sizeof(float));
    static_assert(sizeof(mesh.triangles[0]) == 3 * sizeof(std::int32_t));
    const auto numbers = [](const auto& vectors) {
        using Vector = std::decay_t<decltype(vectors[0])>;
        return vectors.empty()
                   ? List<float>()
                   : List<float>(vectors.front().getValue(),
                                 static_cast<std::int64_t>(vectors.size() * Vector::dimensions()));
    };
    return {numbers(mesh.vertices), numbers(mesh.normals), numbers(mesh.uv),
            // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the signed type
            List<std::int32_t>(reinterpret_cast<const std::int32_t*>(mesh.triangles.data()->data()),
                               3 * static_cast<std::int64_t>(mesh.triangles.size()))};
}

/// Upper bounds for a mesh; larger ones are rejected with an Error.
inline constexpr std::size_t kMaxMeshTriangles = 64'000'000;
inline constexpr std::size_t kMaxMeshVertices = 64'000'000;

/// The shape's arrays, mapped by `map` and rounded to float once. If the map is a reflection, the
/// order of corners is reversed, so that they stay counter-clockwise. Normals of any length, or
/// none, or behind all of their triangles, become unit vectors in front of one of them. Throws
/// Error with `name` if an index, a number or an array's length is invalid, or if the mesh has no
/// triangle.
[[nodiscard]] TriangleMesh make_mesh(const MeshShape& shape, const Mat44& map,
                                     const std::string& name);

}  // namespace carom::render
