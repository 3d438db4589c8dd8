#include "render/geometry/triangle_mesh.h"

#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "core/error.h"
#include "core/limits.h"
#include "render/geometry/validity.h"

namespace carom::render {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
    throw Error("mesh of '" + name + "': " + what);
}

void check_sizes(const MeshShape& shape, const std::string& name) {
    const std::size_t count = shape.vertices.size();
    if (shape.triangles.empty() || count == 0) {
        refuse(name, "it has no triangles");
    }
    if (shape.triangles.size() > input_limit(kMaxMeshTriangles) ||
        count > input_limit(kMaxMeshVertices)) {
        refuse(name, beyond_limit(input_limit(kMaxMeshTriangles), "triangles or vertices"));
    }
    if (!shape.normals.empty() && shape.normals.size() != count) {
        refuse(name, fmt::format("{} normals for {} vertices", shape.normals.size(), count));
    }
    if (!shape.uv.empty() && shape.uv.size() != count) {
        refuse(name, fmt::format("{} texture coordinates for {} vertices", shape.uv.size(), count));
    }
}

/// 0 for a normal that is zero or not finite: it is missing.
Vec3 unit_or_zero(const Vec3& n) {
    const double length = n.length();
    return std::isfinite(length) && length > 0 ? n / length : Vec3(0, 0, 0);
}

/// The shape's normals. Those that are behind all triangles of their vertex are turned around, and
/// vertices without a normal get the mean of their triangles', weighted by area. In the shape's own
/// axes, so that equal shapes have equal normals wherever they are. The indices are valid.
std::vector<Vec3> mended_normals(const MeshShape& shape) {
    std::vector<Vec3> normals;
    normals.reserve(shape.normals.size());
    for (const Vec3& normal : shape.normals) {
        normals.push_back(unit_or_zero(normal));
    }
    std::vector<bool> is_behind_all(normals.size(), true);
    std::vector<Vec3> sums(normals.size(), Vec3(0, 0, 0));
    for (const auto& triangle : shape.triangles) {
        const Vec3& a = shape.vertices[triangle[0]];
        const Vec3 across =
            (shape.vertices[triangle[1]] - a).cross(shape.vertices[triangle[2]] - a);
        for (const std::uint32_t vertex : triangle) {
            is_behind_all[vertex] = is_behind_all[vertex] && across.dot(normals[vertex]) < 0;
            sums[vertex] += across;
        }
    }
    for (std::size_t i = 0; i < normals.size(); ++i) {
        if (normals[i] == Vec3(0, 0, 0)) {
            normals[i] = unit_or_zero(sums[i]);
        } else if (is_behind_all[i]) {
            normals[i] = -normals[i];
        }
    }
    return normals;
}

}  // namespace

TriangleMesh make_mesh(const MeshShape& shape, const Mat44& map, const std::string& name) {
    check_sizes(shape, name);
    TriangleMesh mesh;
    mesh.vertices.reserve(shape.vertices.size());
    for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
        Vec3 p;
        map.multVecMatrix(shape.vertices[i], p);
        mesh.vertices.push_back(V3f(p));
        if (!is_finite(mesh.vertices.back())) {
            refuse(name, fmt::format("vertex {} is not a finite point", i));
        }
    }
    mesh.uv.reserve(shape.uv.size());
    for (const Vec2& uv : shape.uv) {
        const V2f narrow(uv);
        mesh.uv.push_back(std::isfinite(narrow.x) && std::isfinite(narrow.y) ? narrow : V2f(0, 0));
    }
    const bool mirrors = map.determinant() < 0;
    mesh.triangles = shape.triangles;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        auto& triangle = mesh.triangles[i];
        for (const std::uint32_t index : triangle) {
            if (index >= mesh.vertices.size()) {
                refuse(name, fmt::format("triangle {} refers to vertex {} of {}", i, index,
                                         mesh.vertices.size()));
            }
        }
        if (mirrors) {
            std::swap(triangle[1], triangle[2]);
        }
    }
    if (!shape.normals.empty()) {
        const Mat44 normal_map = map.inverse().transposed();
        mesh.normals.reserve(shape.normals.size());
        for (const Vec3& normal : mended_normals(shape)) {
            Vec3 n;
            normal_map.multDirMatrix(normal, n);
            mesh.normals.emplace_back(unit_or_zero(n));
        }
    }
    return mesh;
}

}  // namespace carom::render
