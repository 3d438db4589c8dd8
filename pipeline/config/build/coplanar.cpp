// Warns of coplanar surfaces that overlap: a picture would show a random mixture of both.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "core/elementary.h"
#include "pipeline/config/build/builder.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

/// Planes closer to each other than this (m) are the same for rays in single precision.
constexpr double kSamePlane = 1e-6;
/// Surfaces that overlap by less than this (m) only touch.
constexpr double kTouching = 1e-6;

struct FlatSurface {
    std::string name;           // in messages
    std::vector<Vec3> corners;  // convex, in order; three points of an infinite plane
    bool is_infinite = false;

    [[nodiscard]] Vec3 normal() const {
        return (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    }
};

std::vector<Vec3> disk_corners(double radius) {
    constexpr int kCorners = 64;
    std::vector<Vec3> corners;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCorners;
        corners.emplace_back(radius * cosine(angle), radius * sine(angle), 0);
    }
    return corners;
}

/// The corners in the axes of the shape; empty if it is not flat.
std::vector<Vec3> corners_of(const render::Shape& shape) {
    if (std::holds_alternative<render::PlaneShape>(shape)) {
        return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    }
    if (const auto* rectangle = std::get_if<render::RectangleShape>(&shape)) {
        const double x = rectangle->size.x / 2;
        const double y = rectangle->size.y / 2;
        return {{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}};
    }
    if (const auto* triangle = std::get_if<render::TriangleShape>(&shape)) {
        return {triangle->corners.begin(), triangle->corners.end()};
    }
    if (const auto* sides = std::get_if<render::ParallelogramShape>(&shape)) {
        const Vec3& a = sides->corner;
        return {a, a + sides->edge_u, a + sides->edge_u + sides->edge_v, a + sides->edge_v};
    }
    if (const auto* disk = std::get_if<render::DiskShape>(&shape)) {
        return disk_corners(disk->radius);
    }
    return {};
}

std::optional<FlatSurface> flat_surface_of(const render::ObjectDescription& object) {
    FlatSurface flat;
    flat.corners = corners_of(object.shape);
    flat.is_infinite = std::holds_alternative<render::PlaneShape>(object.shape);
    flat.name = object.name == "table/floor" ? "the floor" : quote(object.name);
    if (flat.corners.empty() || !object.track.empty()) {
        return std::nullopt;
    }
    for (Vec3& corner : flat.corners) {
        object.world_from_object.multVecMatrix(Vec3(corner), corner);
    }
    return flat;
}

FlatSurface cloth_of(const sim::billiards::TableMeasures& table) {
    const Vec2 half =
        Vec2(table.length, table.width) * 0.5 + Vec2(table.has_cushions ? table.cushion_width : 0);
    return {
        "the cloth",
        {{-half.x, -half.y, 0}, {half.x, -half.y, 0}, {half.x, half.y, 0}, {-half.x, half.y, 0}},
        false};
}

/// Whether all of `b` is on the outer side of an edge of `a`.
bool has_separating_edge(const FlatSurface& a, const FlatSurface& b) {
    const Vec3 normal = a.normal();
    for (std::size_t i = 0; i < a.corners.size(); ++i) {
        const Vec3 edge = a.corners[(i + 1) % a.corners.size()] - a.corners[i];
        const Vec3 outwards = edge.cross(normal).normalized();
        const bool is_outside = std::all_of(
            b.corners.begin(), b.corners.end(),
            [&](const Vec3& corner) { return (corner - a.corners[i]).dot(outwards) > -kTouching; });
        if (is_outside) {
            return true;
        }
    }
    return false;
}

bool are_coplanar_and_overlap(const FlatSurface& a, const FlatSurface& b) {
    const Vec3 normal = a.normal();
    if (normal.cross(b.normal()).length() > 1e-9) {
        return false;
    }
    if (std::abs((b.corners[0] - a.corners[0]).dot(normal)) > kSamePlane) {
        return false;
    }
    if (a.is_infinite || b.is_infinite) {
        return true;
    }
    return !has_separating_edge(a, b) && !has_separating_edge(b, a);
}

}  // namespace

void warn_about_coplanar_surfaces(Builder& builder) {
    if (builder.reader.has_error()) {
        return;
    }
    std::vector<FlatSurface> known;
    if (builder.shot.world.table && builder.shot.draws_table) {
        known.push_back(cloth_of(*builder.shot.world.table));
    }
    const auto& objects = builder.shot.scene.objects;
    // The surfaces of the table come first, independently of their order in the scene.
    for (const bool is_table : {true, false}) {
        for (const render::ObjectDescription& object : objects) {
            std::optional<FlatSurface> flat = flat_surface_of(object);
            if (!flat || object.name.starts_with("table/") != is_table) {
                continue;
            }
            const auto other = std::find_if(known.begin(), known.end(), [&](const FlatSurface& k) {
                return are_coplanar_and_overlap(k, *flat);
            });
            if (other != known.end() && !is_table) {
                builder.reader.warning(
                    builder.placed.at(object.name),
                    "object " + flat->name + " lies in the same plane as " + other->name +
                        ", so pictures show specks of both; move one of them by 0.1 mm");
            }
            known.push_back(std::move(*flat));
        }
    }
}

}  // namespace carom::pipeline::config
