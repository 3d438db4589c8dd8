#include "pipeline/picture/tube_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/elementary.h"

namespace carom::pipeline {
namespace {

using render::MeshShape;

constexpr std::uint32_t kSides = 10;     // of a tube, and meridians of a ball
constexpr std::uint32_t kParallels = 6;  // of a ball, with both poles
constexpr double kLeast = 1e-6;          // m between points

std::vector<Vec3> without_repetitions(std::span<const Vec3> points) {
    std::vector<Vec3> result;
    for (const Vec3& point : points) {
        if (result.empty() || (point - result.back()).length() > kLeast) {
            result.push_back(point);
        }
    }
    return result;
}

Vec3 any_perpendicular(const Vec3& direction) {
    const Vec3 other = std::abs(direction.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
    return direction.cross(other).normalized();
}

std::uint32_t size_of(const MeshShape& mesh) {
    return static_cast<std::uint32_t>(mesh.vertices.size());
}

void add_vertex(const Vec3& centre, const Vec3& normal, double radius, MeshShape& mesh) {
    mesh.vertices.push_back(centre + radius * normal);
    mesh.normals.push_back(normal);
}

/// Joins two rings of kSides vertices each.
void add_band(std::uint32_t first, std::uint32_t second, MeshShape& mesh) {
    for (std::uint32_t k = 0; k < kSides; ++k) {
        const std::uint32_t next = (k + 1) % kSides;
        mesh.triangles.push_back({first + k, second + k, second + next});
        mesh.triangles.push_back({first + k, second + next, first + next});
    }
}

/// A ring around a point of a line; `side` is at right angles to `along`.
void add_ring(const Vec3& centre, const Vec3& along, const Vec3& side, double radius,
              MeshShape& mesh) {
    const Vec3 other = along.cross(side);
    for (std::uint32_t k = 0; k < kSides; ++k) {
        const SinCos at = sin_cos(2 * std::numbers::pi * k / kSides);
        add_vertex(centre, at.cos * side + at.sin * other, radius, mesh);
    }
}

}  // namespace

void add_ball(const Vec3& centre, double radius, MeshShape& mesh) {
    const std::uint32_t begin = size_of(mesh);
    for (std::uint32_t i = 0; i < kParallels; ++i) {
        const SinCos height = sin_cos(std::numbers::pi * (i / (kParallels - 1.0) - 0.5));
        for (std::uint32_t k = 0; k < kSides; ++k) {
            const SinCos at = sin_cos(2 * std::numbers::pi * k / kSides);
            add_vertex(centre, {height.cos * at.cos, height.cos * at.sin, height.sin}, radius,
                       mesh);
        }
    }
    for (std::uint32_t i = 0; i + 1 < kParallels; ++i) {
        add_band(begin + i * kSides, begin + (i + 1) * kSides, mesh);
    }
}

void add_tube(std::span<const Vec3> points, bool is_closed, double radius, MeshShape& mesh) {
    const std::vector<Vec3> line = without_repetitions(points);
    if (line.size() == 1) {
        add_ball(line.front(), radius, mesh);
    }
    if (line.size() < 2) {
        return;
    }
    const std::size_t count = line.size();
    const auto point = [&](std::size_t i) { return line[i % count]; };
    const auto direction = [&](std::size_t i) {
        const Vec3 before = i > 0 ? line[i - 1] : is_closed ? line[count - 1] : line[0];
        const Vec3 after = i + 1 < count || is_closed ? point(i + 1) : line[i];
        const Vec3 along = after - before;
        return along.length() > kLeast ? along.normalized() : (point(i + 1) - line[i]).normalized();
    };
    const std::uint32_t begin = size_of(mesh);
    Vec3 side = any_perpendicular(direction(0));
    for (std::size_t i = 0; i < count; ++i) {
        // The side turns no more than the line does.
        const Vec3 along = direction(i);
        const Vec3 turned = side - side.dot(along) * along;
        side = turned.length() > kLeast ? turned.normalized() : any_perpendicular(along);
        add_ring(line[i], along, side, radius, mesh);
    }
    for (std::uint32_t i = 0; i + 1 < count; ++i) {
        add_band(begin + i * kSides, begin + (i + 1) * kSides, mesh);
    }
    if (is_closed) {
        add_band(begin + static_cast<std::uint32_t>(count - 1) * kSides, begin, mesh);
    } else {
        add_ball(line.front(), radius, mesh);
        add_ball(line.back(), radius, mesh);
    }
}

}  // namespace carom::pipeline
