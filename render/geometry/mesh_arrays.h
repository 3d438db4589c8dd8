// A mesh's arrays for kernels.
#pragma once

#include <cstdint>

namespace carom::render {

/// Borrowed: the numbers of a TriangleMesh one after the other.
struct MeshArrays {
    const float* vertices = nullptr;
    const float* normals = nullptr;  // null: none
    const float* uv = nullptr;       // null: none
    const std::int32_t* triangles = nullptr;
};

}  // namespace carom::render
