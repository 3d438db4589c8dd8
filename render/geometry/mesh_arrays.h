// A mesh's arrays for kernels.
#pragma once

#include <cstdint>

#include "render/geometry/triangle_mesh.h"

namespace carom::render {

/// Borrowed: the numbers of a TriangleMesh one after the other.
struct MeshArrays {
    const float* vertices = nullptr;
    const float* normals = nullptr;  // null: none
    const float* uv = nullptr;       // null: none
    const std::int32_t* triangles = nullptr;
};

[[nodiscard]] inline MeshArrays arrays_of(const TriangleMesh& mesh) {
    static_assert(sizeof(V3f) == 3 * sizeof(float) && sizeof(V2f) == 2 * sizeof(float));
    static_assert(sizeof(mesh.triangles[0]) == 3 * sizeof(std::int32_t));
    return {mesh.vertices.data()->getValue(),
            mesh.normals.empty() ? nullptr : mesh.normals.data()->getValue(),
            mesh.uv.empty() ? nullptr : mesh.uv.data()->getValue(),
            // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the signed type
            reinterpret_cast<const std::int32_t*>(mesh.triangles.data()->data())};
}

}  // namespace carom::render
