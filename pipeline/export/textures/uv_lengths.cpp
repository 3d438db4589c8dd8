#include "pipeline/export/textures/uv_lengths.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/geometry/affine.h"

namespace carom::pipeline {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// The axis along which v is longest; of several the first.
int longest_axis(const Vec3& v) {
    const Vec3 size(std::abs(v.x), std::abs(v.y), std::abs(v.z));
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

struct LengthsOf {
    const Vec3& normal;
    const Mat44& map;
    Vec3 scale = render::axis_scales(map);

    Vec2 operator()(const render::SphereShape& sphere) const {
        return sphere.radius * Vec2(kTurn * scale.x, kTurn / 2 * scale.z);
    }
    Vec2 operator()(const render::BoxShape& box) const { return of_side(box.size); }
    Vec2 operator()(const render::RoundedBoxShape& box) const { return of_side(box.size); }
    Vec2 operator()(const render::PlaneShape&) const { return {scale.x, scale.y}; }
    Vec2 operator()(const render::RectangleShape& rectangle) const {
        return {rectangle.size.x * scale.x, rectangle.size.y * scale.y};
    }
    Vec2 operator()(const render::MeshShape&) const { return {0, 0}; }
    Vec2 operator()(const render::TriangleShape& triangle) const {
        const auto& [a, b, c] = triangle.corners;
        return {mapped(b - a), mapped(c - a)};
    }
    Vec2 operator()(const render::ParallelogramShape& p) const {
        return {mapped(p.edge_u), mapped(p.edge_v)};
    }
    Vec2 operator()(const render::DiskShape& disk) const { return across(disk.radius); }
    Vec2 operator()(const render::CylinderShape& cylinder) const {
        return of_frustum(cylinder.radius, cylinder.height);
    }
    Vec2 operator()(const render::ConeShape& cone) const {
        return of_frustum(std::max(cone.radius, cone.top_radius), cone.height);
    }
    Vec2 operator()(const render::CapsuleShape& capsule) const {
        return {kTurn * capsule.radius * scale.x,
                (capsule.length + kTurn / 2 * capsule.radius) * scale.z};
    }

  private:
    [[nodiscard]] double mapped(const Vec3& edge) const {
        Vec3 result;
        map.multDirMatrix(edge, result);
        return result.length();
    }
    [[nodiscard]] Vec2 of_side(const Vec3& size) const {
        const int axis = longest_axis(normal);
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        return {size[u] * scale[u], size[v] * scale[v]};
    }
    [[nodiscard]] Vec2 across(double radius) const { return 2 * radius * Vec2(scale.x, scale.y); }
    [[nodiscard]] Vec2 of_frustum(double radius, double height) const {
        constexpr double kLevel = 1e-5;
        const bool is_end =
            std::max(std::abs(normal.x), std::abs(normal.y)) <= kLevel * std::abs(normal.z);
        return is_end ? across(radius) : Vec2(kTurn * radius * scale.x, height * scale.z);
    }
};

/// A triangle and how coordinates grow across it.
struct Growth {
    Vec3 along_u{0, 0, 0};  // of the position, while u grows by 1 and v stays
    Vec3 along_v{0, 0, 0};
    double area = 0;
    double area_of_coordinates = 0;
};

Growth growth(const render::TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle,
              const std::vector<Imath::V2f>& coordinates) {
    const auto& [a, b, c] = triangle;
    const Vec3 edge_b = Vec3(mesh.vertices[b]) - Vec3(mesh.vertices[a]);
    const Vec3 edge_c = Vec3(mesh.vertices[c]) - Vec3(mesh.vertices[a]);
    const Vec2 uv_b = Vec2(coordinates[b]) - Vec2(coordinates[a]);
    const Vec2 uv_c = Vec2(coordinates[c]) - Vec2(coordinates[a]);
    const double determinant = uv_b.x * uv_c.y - uv_b.y * uv_c.x;
    Growth result;
    result.area = edge_b.cross(edge_c).length() / 2;
    result.area_of_coordinates = std::abs(determinant) / 2;
    if (determinant != 0) {
        result.along_u = (uv_c.y * edge_b - uv_b.y * edge_c) / determinant;
        result.along_v = (uv_b.x * edge_c - uv_c.x * edge_b) / determinant;
    }
    return result;
}

}  // namespace

Vec2 uv_lengths(const render::Shape& shape, const Vec3& normal, const Mat44& map) {
    return std::visit(LengthsOf{normal, map}, shape);
}

double uv_length(const render::TriangleMesh& mesh) {
    double area = 0;
    double area_of_uv = 0;
    for (const auto& triangle : mesh.triangles) {
        const Growth grown = growth(mesh, triangle, mesh.uv);
        area += grown.area;
        area_of_uv += grown.area_of_coordinates;
    }
    return area_of_uv > 0 ? std::sqrt(area / area_of_uv) : 0;
}

Vec2 mean_lengths(const render::TriangleMesh& mesh, const std::vector<Imath::V2f>& coordinates) {
    Vec2 sum(0, 0);
    double area = 0;
    for (const auto& triangle : mesh.triangles) {
        const Growth grown = growth(mesh, triangle, coordinates);
        if (grown.area_of_coordinates > 0) {
            sum += grown.area * Vec2(grown.along_u.length(), grown.along_v.length());
            area += grown.area;
        }
    }
    return area > 0 && sum.x > 0 && sum.y > 0 ? sum / area : Vec2(1, 1);
}

}  // namespace carom::pipeline
