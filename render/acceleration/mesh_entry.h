// A mesh of a scene as input of acceleration structures.
#pragma once

#include <cstdint>

#include "render/geometry/triangle_mesh.h"

namespace carom::render {

/// A mesh, and the object that its hits report.
struct MeshEntry {
    const TriangleMesh* mesh = nullptr;  // outlives what is built from it, unless that copies it
    std::uint32_t object = 0;
};

}  // namespace carom::render
