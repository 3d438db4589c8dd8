// A mesh's arrays for kernels.
#pragma once

#include <cstdint>

#include "render/lanes/list.h"

namespace carom::render {

/// Borrowed: the numbers of a TriangleMesh one after the other.
struct MeshArrays {
    List<float> vertices;
    List<float> normals, uv;  // the mesh may have none
    List<std::int32_t> triangles;

    template <class Visit>
    void each_list(const Visit& visit) {
        visit(vertices, normals, uv, triangles);
    }
};

}  // namespace carom::render
