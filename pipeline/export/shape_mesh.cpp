#include "pipeline/export/shape_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/elementary.h"
#include "render/geometry/mesh_file.h"

namespace carom::pipeline {

namespace {

using render::MeshShape;

constexpr std::uint32_t kSides = 64;
constexpr std::uint32_t kRings = 32;  // of a sphere, from pole to pole
constexpr double kPlaneSize = 40;     // m

Vec3 around(std::uint32_t side) {
    const double angle = 2 * std::numbers::pi * side / kSides;
    return {cosine(angle), sine(angle), 0};
}

/// Adds a flat polygon with its own vertices, counter-clockwise seen from its front.
void add_polygon(MeshShape& mesh, const std::vector<Vec3>& corners) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    for (const Vec3& corner : corners) {
        mesh.vertices.push_back(corner);
        mesh.normals.push_back(normal);
    }
    for (std::uint32_t i = 2; i < corners.size(); ++i) {
        mesh.triangles.push_back({first, first + i - 1, first + i});
    }
}

MeshShape box_mesh(const Vec3& size) {
    MeshShape mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            Vec3 out(0, 0, 0);
            Vec3 u(0, 0, 0);
            Vec3 v(0, 0, 0);
            out[axis] = side * size[axis] / 2;
            u[(axis + 1) % 3] = side * size[(axis + 1) % 3] / 2;
            v[(axis + 2) % 3] = size[(axis + 2) % 3] / 2;
            add_polygon(mesh, {out - u - v, out + u - v, out + u + v, out - u + v});
        }
    }
    return mesh;
}

MeshShape rectangle_mesh(double x, double y) {
    MeshShape mesh;
    add_polygon(mesh,
                {{-x / 2, -y / 2, 0}, {x / 2, -y / 2, 0}, {x / 2, y / 2, 0}, {-x / 2, y / 2, 0}});
    return mesh;
}

void add_disk(MeshShape& mesh, double radius, double z, bool faces_up) {
    std::vector<Vec3> rim;
    for (std::uint32_t i = 0; i < kSides; ++i) {
        rim.push_back(radius * around(faces_up ? i : kSides - i) + Vec3(0, 0, z));
    }
    add_polygon(mesh, rim);
}

/// A frustum with radius `bottom` at -height / 2 and `top` at height / 2; a radius of 0 gives a
/// tip.
MeshShape frustum_mesh(double bottom, double top, double height) {
    MeshShape mesh;
    const Vec3 rise(0, 0, (bottom - top) / height);
    for (const double end : {-1.0, 1.0}) {
        for (std::uint32_t i = 0; i < kSides; ++i) {
            mesh.vertices.push_back((end < 0 ? bottom : top) * around(i) +
                                    Vec3(0, 0, end * height / 2));
            mesh.normals.push_back((around(i) + rise).normalized());
        }
    }
    for (std::uint32_t i = 0; i < kSides; ++i) {
        const std::uint32_t next = (i + 1) % kSides;
        if (bottom > 0) {
            mesh.triangles.push_back({i, next, kSides + next});
        }
        if (top > 0) {
            mesh.triangles.push_back({i, kSides + next, kSides + i});
        }
    }
    if (bottom > 0) {
        add_disk(mesh, bottom, -height / 2, false);
    }
    if (top > 0) {
        add_disk(mesh, top, height / 2, true);
    }
    return mesh;
}

/// A sphere cut at its equator, with one half at each end. The vertices of the equator exist twice,
/// and the side connects them.
MeshShape capsule_mesh(double radius, double length) {
    MeshShape mesh = unit_sphere_mesh();
    const auto split = static_cast<std::uint32_t>(mesh.vertices.size());
    const std::uint32_t equator = 1 + (kRings / 2 - 1) * kSides;
    for (std::uint32_t i = 0; i < kSides; ++i) {
        const Vec3 vertex = mesh.vertices[equator + i];
        mesh.vertices.push_back(vertex);
        mesh.normals.push_back(mesh.normals[equator + i]);
    }
    // The lower half uses the original equator, the upper half uses the copies.
    const auto is_upper = [&](std::uint32_t corner) {
        return corner < split && mesh.vertices[corner].z > 1e-9;
    };
    for (auto& triangle : mesh.triangles) {
        if (std::ranges::any_of(triangle, is_upper)) {
            for (std::uint32_t& corner : triangle) {
                const bool is_on_equator = corner >= equator && corner < equator + kSides;
                corner = is_on_equator ? split + corner - equator : corner;
            }
        }
    }
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
        const bool goes_up = i >= split || is_upper(i);
        mesh.vertices[i] = radius * mesh.vertices[i] + Vec3(0, 0, (goes_up ? 0.5 : -0.5) * length);
    }
    for (std::uint32_t i = 0; i < kSides; ++i) {
        const std::uint32_t next = (i + 1) % kSides;
        mesh.triangles.push_back({equator + i, equator + next, split + next});
        mesh.triangles.push_back({equator + i, split + next, split + i});
    }
    return mesh;
}

/// A position across a face of a rounded box, on the rounding at one side of its flat middle.
struct Rounding {
    double slope;  // of the normal relative to the face normal; at 1 the next face begins
    double side;   // the end of the core that it rounds, -1 or 1
};

/// `core`: half of the core's length across the face.
std::vector<Rounding> roundings(double core) {
    constexpr int kSteps = static_cast<int>(kSides) / 8;  // to the diagonal
    std::vector<Rounding> result;
    for (const int side : {-1, 1}) {
        for (int i = 0; i <= kSteps; ++i) {
            const int step = side < 0 ? i - kSteps : i;
            if (step != 0 || side < 0 || core > 0) {
                result.push_back(
                    {tangent(std::numbers::pi / 4 * step / kSteps), static_cast<double>(side)});
            }
        }
    }
    return result;
}

void add_rounded_face(MeshShape& mesh, const render::RoundedBoxShape& box, int axis, double side) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const Vec3 core = box.core();
    const auto across = roundings(core[u]);
    const auto along = roundings(core[v]);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Rounding& j : along) {
        for (const Rounding& i : across) {
            Vec3 normal(0, 0, 0);
            normal[axis] = side;
            normal[u] = side * i.slope;  // preserves the orientation seen from outside
            normal[v] = j.slope;
            normal.normalize();
            Vec3 corner(0, 0, 0);
            corner[axis] = side * core[axis];
            corner[u] = side * i.side * core[u];
            corner[v] = j.side * core[v];
            mesh.vertices.push_back(corner + box.radius * normal);
            mesh.normals.push_back(normal);
        }
    }
    const auto width = static_cast<std::uint32_t>(across.size());
    for (std::uint32_t row = 0; row + 1 < along.size(); ++row) {
        for (std::uint32_t i = first + row * width; i + 1 < first + (row + 1) * width; ++i) {
            mesh.triangles.push_back({i, i + 1, i + width + 1});
            mesh.triangles.push_back({i, i + width + 1, i + width});
        }
    }
}

struct MeshOf {
    MeshShape operator()(const render::SphereShape& sphere) const {
        MeshShape mesh = unit_sphere_mesh();
        for (Vec3& vertex : mesh.vertices) {
            vertex *= sphere.radius;
        }
        return mesh;
    }
    MeshShape operator()(const render::BoxShape& box) const { return box_mesh(box.size); }
    MeshShape operator()(const render::PlaneShape&) const {
        return rectangle_mesh(kPlaneSize, kPlaneSize);
    }
    MeshShape operator()(const render::RectangleShape& rectangle) const {
        return rectangle_mesh(rectangle.size.x, rectangle.size.y);
    }
    MeshShape operator()(const MeshShape& mesh) const {
        if (mesh.file.empty()) {
            return mesh;
        }
        MeshShape read = render::read_mesh(mesh.file);
        read.smooth_angle = mesh.smooth_angle;
        return read;
    }
    MeshShape operator()(const render::TriangleShape& triangle) const {
        MeshShape mesh;
        add_polygon(mesh, {triangle.corners.begin(), triangle.corners.end()});
        return mesh;
    }
    MeshShape operator()(const render::ParallelogramShape& p) const {
        MeshShape mesh;
        add_polygon(mesh, {p.corner, p.corner + p.edge_u, p.corner + p.edge_u + p.edge_v,
                           p.corner + p.edge_v});
        return mesh;
    }
    MeshShape operator()(const render::DiskShape& disk) const {
        MeshShape mesh;
        add_disk(mesh, disk.radius, 0, true);
        return mesh;
    }
    MeshShape operator()(const render::CylinderShape& cylinder) const {
        return frustum_mesh(cylinder.radius, cylinder.radius, cylinder.height);
    }
    MeshShape operator()(const render::ConeShape& cone) const {
        return frustum_mesh(cone.radius, cone.top_radius, cone.height);
    }
    MeshShape operator()(const render::CapsuleShape& capsule) const {
        return capsule_mesh(capsule.radius, capsule.length);
    }
    MeshShape operator()(const render::RoundedBoxShape& box) const {
        MeshShape mesh;
        for (int axis = 0; axis < 3; ++axis) {
            add_rounded_face(mesh, box, axis, -1);
            add_rounded_face(mesh, box, axis, 1);
        }
        return mesh;
    }
};

/// The point where the plane crosses the edge from a to b, moved along the sphere onto the circle.
Vec3 on_circle(const Vec3& a, const Vec3& b, const Vec3& normal, double distance) {
    const double da = normal.dot(a) - distance;
    const double db = normal.dot(b) - distance;
    const Vec3 crossing = a + (da / (da - db)) * (b - a);
    const Vec3 across = (crossing - normal.dot(crossing) * normal).normalized();
    return distance * normal + std::sqrt(1 - distance * distance) * across;
}

}  // namespace

MeshShape unit_sphere_mesh() {
    MeshShape mesh;
    mesh.vertices.emplace_back(0, 0, -1);
    for (std::uint32_t ring = 1; ring < kRings; ++ring) {
        const double latitude = std::numbers::pi * (static_cast<double>(ring) / kRings - 0.5);
        for (std::uint32_t i = 0; i < kSides; ++i) {
            mesh.vertices.push_back(cosine(latitude) * around(i) + Vec3(0, 0, sine(latitude)));
        }
    }
    mesh.vertices.emplace_back(0, 0, 1);
    const auto top = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    const auto at = [](std::uint32_t ring, std::uint32_t side) {
        return 1 + (ring - 1) * kSides + side % kSides;
    };
    for (std::uint32_t i = 0; i < kSides; ++i) {
        mesh.triangles.push_back({0, at(1, i + 1), at(1, i)});
        for (std::uint32_t ring = 1; ring + 1 < kRings; ++ring) {
            mesh.triangles.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i + 1)});
            mesh.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring + 1, i)});
        }
        mesh.triangles.push_back({at(kRings - 1, i), at(kRings - 1, i + 1), top});
    }
    mesh.normals = mesh.vertices;
    return mesh;
}

void cut_unit_sphere(MeshShape& sphere, const Vec3& normal, double distance) {
    constexpr double kOn = 1e-9;  // tolerance for points on the plane
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings;
    const auto side_of = [&](std::uint32_t corner) {
        const double height = normal.dot(sphere.vertices[corner]) - distance;
        return height > kOn ? 1 : height < -kOn ? -1 : 0;
    };
    const auto crossing = [&](std::uint32_t a, std::uint32_t b) {
        const auto [known, is_new] = crossings.try_emplace(
            std::minmax(a, b), static_cast<std::uint32_t>(sphere.vertices.size()));
        if (is_new) {
            const Vec3 point = on_circle(sphere.vertices[std::min(a, b)],
                                         sphere.vertices[std::max(a, b)], normal, distance);
            sphere.vertices.push_back(point);
            sphere.normals.push_back(point);
        }
        return known->second;
    };
    std::vector<std::array<std::uint32_t, 3>> result;
    for (const auto& triangle : std::exchange(sphere.triangles, {})) {
        // The corners of both parts, in order; a corner on the plane belongs to both.
        std::array<std::vector<std::uint32_t>, 2> parts;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t corner = triangle[i];
            const std::uint32_t next = triangle[(i + 1) % 3];
            const int side = side_of(corner);
            for (const int part : {0, 1}) {
                if (side == 0 || (side > 0) == (part == 1)) {
                    parts[static_cast<std::size_t>(part)].push_back(corner);
                }
            }
            if (side * side_of(next) < 0) {
                const std::uint32_t between = crossing(corner, next);
                parts[0].push_back(between);
                parts[1].push_back(between);
            }
        }
        for (const std::vector<std::uint32_t>& part : parts) {
            for (std::size_t i = 2; i < part.size(); ++i) {
                result.push_back({part[0], part[i - 1], part[i]});
            }
        }
    }
    sphere.triangles = std::move(result);
}

MeshShape shape_mesh(const render::Shape& shape) {
    return std::visit(MeshOf{}, shape);
}

}  // namespace carom::pipeline
