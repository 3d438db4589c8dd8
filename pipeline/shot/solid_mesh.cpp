#include "pipeline/shot/solid_mesh.h"

#include <cstdint>
#include <numbers>

#include "core/elementary.h"

namespace carom::pipeline {
namespace {

constexpr std::uint32_t kSides = 96;

Vec3 unit_circle_point(std::uint32_t side) {
    const double angle = 2 * std::numbers::pi * side / kSides;
    return {cosine(angle), sine(angle), 0};
}

/// Adds a flat face that has its own vertices.
void add_face(render::MeshShape& mesh, const std::vector<Vec3>& corners, const Vec3& normal) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec3& corner : corners) {
        mesh.vertices.push_back(corner);
        mesh.normals.push_back(normal);
    }
    for (std::uint32_t i = 2; i < corners.size(); ++i) {
        mesh.triangles.push_back({first, first + i - 1, first + i});
    }
}

}  // namespace

sim::TriangleMesh disk_mesh(double radius) {
    sim::TriangleMesh mesh;
    mesh.vertices.emplace_back(0, 0, 0);
    for (std::uint32_t i = 0; i < kSides; ++i) {
        mesh.vertices.push_back(unit_circle_point(i) * radius);
        mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % kSides});
    }
    return mesh;
}

sim::TriangleMesh cone_mesh(const render::ConeShape& cone) {
    std::vector<Vec3> points;
    for (const double end : {-0.5, 0.5}) {
        const double radius = end < 0 ? cone.radius : cone.top_radius;
        const Vec3 centre(0, 0, end * cone.height);
        for (std::uint32_t i = 0; i < (radius > 0 ? kSides : 1); ++i) {
            points.push_back(centre + unit_circle_point(i) * radius);
        }
    }
    sim::TriangleMesh mesh;
    const std::optional<sim::Polyhedron> hull = sim::convex_hull(points);
    if (!hull) {
        return mesh;
    }
    mesh.vertices = hull->vertices;
    for (const sim::PolyhedronFace& face : hull->faces) {
        for (std::size_t i = 2; i < face.corners.size(); ++i) {
            mesh.triangles.push_back({face.corners[0], face.corners[i - 1], face.corners[i]});
        }
    }
    return mesh;
}

render::MeshShape hull_mesh(const sim::Polyhedron& hull) {
    render::MeshShape mesh;
    for (const sim::PolyhedronFace& face : hull.faces) {
        std::vector<Vec3> corners;
        for (const std::uint32_t corner : face.corners) {
            corners.push_back(hull.vertices[corner]);
        }
        add_face(mesh, corners, face.normal);
    }
    return mesh;
}

}  // namespace carom::pipeline
