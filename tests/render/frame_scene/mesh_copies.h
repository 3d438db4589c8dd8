// Many objects with one mesh, and a structure maker that keeps a copy of it for each.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <span>

#include "render/acceleration/hybrid_structure.h"
#include "render/acceleration/structure_maker.h"
#include "render/acceleration/triangle_scene.h"
#include "render/scene/scene_description.h"

namespace carom::test {

/// A closed, bumpy surface with normals and uv: 2 * rings * rings triangles.
inline render::MeshShape bumpy_mesh(int rings, double radius) {
    render::MeshShape mesh;
    const auto point = [&](int i, int j) {
        const double theta = std::numbers::pi * i / rings;
        const double phi = 2 * std::numbers::pi * (j % rings) / rings;
        const double sine = i % rings == 0 ? 0 : std::sin(theta);
        const double r = radius * (1 + 0.2 * sine * std::sin(5 * theta) * std::cos(4 * phi));
        return Vec3(r * sine * std::cos(phi), r * sine * std::sin(phi), r * std::cos(theta));
    };
    for (int i = 0; i <= rings; ++i) {
        for (int j = 0; j <= rings; ++j) {
            mesh.vertices.push_back(point(i, j));
            mesh.normals.push_back(mesh.vertices.back().normalized());
            mesh.uv.emplace_back(static_cast<double>(j) / rings, static_cast<double>(i) / rings);
        }
    }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * (rings + 1) + j); };
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < rings; ++j) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return mesh;
}

/// The renderer's own structure over a copy of the mesh for each object.
inline render::StructureMaker copying_maker() {
    return [](const render::ShapeSet& shapes, std::span<const render::MeshEntry> meshes) {
        render::ShapeSet all = shapes;
        all.meshes = std::make_shared<const render::TriangleScene>(meshes);
        return std::make_unique<render::HybridStructure>(all);
    };
}

}  // namespace carom::test
