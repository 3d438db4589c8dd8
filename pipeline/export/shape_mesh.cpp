#include "pipeline/export/shape_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/elementary.h"
#include "pipeline/export/textures/globe.h"
#include "pipeline/export/textures/split_vertices.h"
#include "render/geometry/mesh_file.h"

namespace carom::pipeline {

namespace {

using render::MeshShape;

constexpr std::uint32_t kSides = 64;
constexpr std::uint32_t kRings = 32;  // of a sphere, from pole to pole
constexpr double kPlaneSize = 40;     // m

/// uv of a point in a square or on a side of a box around the origin, whose sides have these
/// lengths.
Vec2 across_face(double x, double width, double y, double height) {
    return {x / width + 0.5, y / height + 0.5};
}

Vec3 around(std::uint32_t side) {
    const double angle = 2 * std::numbers::pi * side / kSides;
    return {cosine(angle), sine(angle), 0};
}

/// Adds a flat polygon with its own vertices, counter-clockwise seen from its front. `uv_of` a
/// corner, given its index.
template <class UvOf>
void add_polygon(MeshShape& mesh, const std::vector<Vec3>& corners, UvOf uv_of) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        mesh.vertices.push_back(corners[i]);
        mesh.normals.push_back(normal);
        mesh.uv.push_back(uv_of(i));
    }
    for (std::uint32_t i = 2; i < corners.size(); ++i) {
        mesh.triangles.push_back({first, first + i - 1, first + i});
    }
}

MeshShape box_mesh(const Vec3& size) {
    MeshShape mesh;
    for (int axis = 0; axis < 3; ++axis) {
        const int a = (axis + 1) % 3;
        const int b = (axis + 2) % 3;
        for (const double side : {-1.0, 1.0}) {
            Vec3 out(0, 0, 0);
            Vec3 u(0, 0, 0);
            Vec3 v(0, 0, 0);
            out[axis] = side * size[axis] / 2;
            u[a] = side * size[a] / 2;
            v[b] = size[b] / 2;
            const std::vector<Vec3> corners{out - u - v, out + u - v, out + u + v, out - u + v};
            add_polygon(mesh, corners, [&](std::size_t i) {
                return across_face(corners[i][a], size[a], corners[i][b], size[b]);
            });
        }
    }
    return mesh;
}

std::vector<Vec3> rectangle(double x, double y) {
    return {{-x / 2, -y / 2, 0}, {x / 2, -y / 2, 0}, {x / 2, y / 2, 0}, {-x / 2, y / 2, 0}};
}

MeshShape rectangle_mesh(double x, double y) {
    MeshShape mesh;
    const std::vector<Vec3> corners = rectangle(x, y);
    add_polygon(mesh, corners,
                [&](std::size_t i) { return across_face(corners[i].x, x, corners[i].y, y); });
    return mesh;
}

MeshShape plane_mesh() {
    MeshShape mesh;
    const std::vector<Vec3> corners = rectangle(kPlaneSize, kPlaneSize);
    add_polygon(mesh, corners, [&](std::size_t i) { return Vec2(corners[i].x, corners[i].y); });
    return mesh;
}

/// `of_square`: radius of the circle whose bounding square uv go across.
void add_disk(MeshShape& mesh, double radius, double of_square, double z, bool faces_up) {
    std::vector<Vec3> rim;
    for (std::uint32_t i = 0; i < kSides; ++i) {
        rim.push_back(radius * around(faces_up ? i : kSides - i) + Vec3(0, 0, z));
    }
    add_polygon(mesh, rim, [&](std::size_t i) {
        return across_face(rim[i].x, 2 * of_square, rim[i].y, 2 * of_square);
    });
}

/// One end of the side of a frustum: a vertex per side of the round, and the first again at the
/// seam.
void add_end(MeshShape& mesh, double radius, double z, const Vec3& rise, double v) {
    for (std::uint32_t i = 0; i <= kSides; ++i) {
        // A tip belongs to the triangle between this side and the next.
        const double turns = (i + (radius > 0 ? 0 : 0.5)) / kSides;
        mesh.vertices.push_back(radius * around(i) + Vec3(0, 0, z));
        mesh.normals.push_back((around(i) + rise).normalized());
        mesh.uv.emplace_back(turns, v);
    }
}

/// A frustum with radius `bottom` at -height / 2 and `top` at height / 2; a radius of 0 gives a
/// tip.
MeshShape frustum_mesh(double bottom, double top, double height) {
    constexpr std::uint32_t kColumns = kSides + 1;
    MeshShape mesh;
    const Vec3 rise(0, 0, (bottom - top) / height);
    add_end(mesh, bottom, -height / 2, rise, 0);
    add_end(mesh, top, height / 2, rise, 1);
    for (std::uint32_t i = 0; i < kSides; ++i) {
        const std::uint32_t above = kColumns + i;
        if (bottom > 0) {
            mesh.triangles.push_back({i, i + 1, top > 0 ? above + 1 : above});
        }
        if (top > 0) {
            mesh.triangles.push_back({i, above + 1, above});
        }
    }
    const double larger = std::max(bottom, top);
    if (bottom > 0) {
        add_disk(mesh, bottom, larger, -height / 2, false);
    }
    if (top > 0) {
        add_disk(mesh, top, larger, height / 2, true);
    }
    return mesh;
}

/// Gives a mesh around the z axis the longitudes of its normals as u. `v_of` a vertex.
template <class VOf>
void add_round_uv(MeshShape& mesh, VOf v_of) {
    std::vector<std::array<Vec2, 3>> corners;
    for (const auto& triangle : mesh.triangles) {
        const std::array<double, 3> u = longitudes(
            {mesh.normals[triangle[0]], mesh.normals[triangle[1]], mesh.normals[triangle[2]]});
        corners.push_back({Vec2(u[0], v_of(triangle[0])), Vec2(u[1], v_of(triangle[1])),
                           Vec2(u[2], v_of(triangle[2]))});
    }
    mesh.uv = split_vertices(mesh, corners);
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
    // v is the length along the surface from the lower pole.
    const double arc = std::numbers::pi * radius;
    add_round_uv(mesh, [&](std::uint32_t i) {
        const double straight = mesh.vertices[i].z > 0 ? length : 0;
        return (arc * latitude(mesh.normals[i]) + straight) / (arc + length);
    });
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
            mesh.uv.push_back(across_face(mesh.vertices.back()[u], box.size[u],
                                          mesh.vertices.back()[v], box.size[v]));
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
        add_round_uv(mesh, [&](std::uint32_t i) { return latitude(mesh.normals[i]); });
        return mesh;
    }
    MeshShape operator()(const render::BoxShape& box) const { return box_mesh(box.size); }
    MeshShape operator()(const render::PlaneShape&) const { return plane_mesh(); }
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
        add_polygon(mesh, {triangle.corners.begin(), triangle.corners.end()},
                    [](std::size_t i) { return Vec2(i == 1, i == 2); });
        return mesh;
    }
    MeshShape operator()(const render::ParallelogramShape& p) const {
        MeshShape mesh;
        add_polygon(
            mesh,
            {p.corner, p.corner + p.edge_u, p.corner + p.edge_u + p.edge_v, p.corner + p.edge_v},
            [](std::size_t i) { return Vec2(i == 1 || i == 2, i >= 2); });
        return mesh;
    }
    MeshShape operator()(const render::DiskShape& disk) const {
        MeshShape mesh;
        add_disk(mesh, disk.radius, disk.radius, 0, true);
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
