#include "pipeline/plan/scene_outline.h"

#include <cmath>

#include "core/error.h"
#include "render/geometry/mesh_file.h"

namespace carom::pipeline {

namespace {

constexpr int kRoundSides = 48;
constexpr int kRings = 12;  // of a sphere, from pole to pole
constexpr double kTurn = 6.283185307179586;

void add_circle(std::vector<Vec3>& points, double radius, double height) {
    for (int i = 0; i < kRoundSides; ++i) {
        const double angle = kTurn * i / kRoundSides;
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
}

/// Outline points in object axes.
struct Points {
    std::vector<Vec3> operator()(const render::SphereShape& sphere) const {
        std::vector<Vec3> points;
        for (int ring = 0; ring <= kRings; ++ring) {
            const double angle = kTurn / 2 * ring / kRings;
            add_circle(points, sphere.radius * std::sin(angle), sphere.radius * std::cos(angle));
        }
        return points;
    }
    std::vector<Vec3> operator()(const render::BoxShape& box) const {
        std::vector<Vec3> points;
        points.reserve(8);
        for (int i = 0; i < 8; ++i) {
            points.push_back(
                0.5 * box.size *
                Vec3((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1));
        }
        return points;
    }
    std::vector<Vec3> operator()(const render::PlaneShape&) const { return {}; }
    std::vector<Vec3> operator()(const render::RectangleShape& r) const {
        const Vec2 half = 0.5 * r.size;
        return {
            {-half.x, -half.y, 0}, {half.x, -half.y, 0}, {half.x, half.y, 0}, {-half.x, half.y, 0}};
    }
    std::vector<Vec3> operator()(const render::MeshShape& mesh) const {
        try {
            return mesh.file.empty() ? mesh.vertices : render::read_mesh(mesh.file).vertices;
        } catch (const Error&) {  // the renderer reports this error
            return {};
        }
    }
    std::vector<Vec3> operator()(const render::TriangleShape& triangle) const {
        return {triangle.corners.begin(), triangle.corners.end()};
    }
    std::vector<Vec3> operator()(const render::ParallelogramShape& p) const {
        return {p.corner, p.corner + p.edge_u, p.corner + p.edge_v, p.corner + p.edge_u + p.edge_v};
    }
    std::vector<Vec3> operator()(const render::DiskShape& disk) const {
        std::vector<Vec3> points;
        add_circle(points, disk.radius, 0);
        return points;
    }
    std::vector<Vec3> operator()(const render::CylinderShape& cylinder) const {
        std::vector<Vec3> points;
        add_circle(points, cylinder.radius, -cylinder.height / 2);
        add_circle(points, cylinder.radius, cylinder.height / 2);
        return points;
    }
    std::vector<Vec3> operator()(const render::ConeShape& cone) const {
        std::vector<Vec3> points;
        add_circle(points, cone.radius, -cone.height / 2);
        add_circle(points, cone.top_radius, cone.height / 2);
        return points;
    }
    std::vector<Vec3> operator()(const render::CapsuleShape& capsule) const {
        std::vector<Vec3> points = (*this)(render::SphereShape{capsule.radius});
        const std::size_t count = points.size();
        for (std::size_t i = 0; i < count; ++i) {
            points.push_back(points[i] + Vec3(0, 0, capsule.length / 2));
            points[i].z -= capsule.length / 2;
        }
        return points;
    }
    std::vector<Vec3> operator()(const render::RoundedBoxShape& box) const {
        std::vector<Vec3> points;
        for (const Vec3& corner : (*this)(render::BoxShape{2.0 * box.core()})) {
            for (const Vec3& p : (*this)(render::SphereShape{box.radius})) {
                points.push_back(corner + p);
            }
        }
        return points;
    }
};

}  // namespace

std::vector<Vec3> outline_points(const render::ObjectDescription& object) {
    std::vector<Vec3> points = std::visit(Points{}, object.shape);
    for (Vec3& point : points) {
        point = point * object.world_from_object;
    }
    return points;
}

}  // namespace carom::pipeline
