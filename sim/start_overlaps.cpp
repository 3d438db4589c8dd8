#include "sim/start_overlaps.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "core/finite.h"
#include "sim/solid_shape.h"
#include "sim/spatial/convex_impact_time.h"
#include "sim/spatial/static_mesh.h"

namespace carom::sim {
namespace {

/// Level surfaces take balls this far in them or above them (m) as standing on them.
constexpr double kRoundOff = 1e-6;
/// Drawn surfaces are polygons: this much inside one (m) is not meant.
constexpr double kPolygon = 1e-4;

struct Ball {
    Vec3 centre;
    double radius = 0;
    Vec2 level;  // the centre from above
};

/// The farthest reach found so far.
class Deepest {
  public:
    void offer(double depth, double tolerance, const std::string& other) {
        if (depth > tolerance && depth > depth_) {
            depth_ = depth;
            other_ = other;
        }
    }
    [[nodiscard]] std::optional<StartOverlap> of(const std::string& ball) const {
        if (other_.empty()) {
            return std::nullopt;
        }
        return StartOverlap{ball, other_, depth_};
    }

  private:
    double depth_ = 0;
    std::string other_;
};

bool is_over_pocket(const Vec2& place, const billiards::TableGeometry& table, double margin = 0) {
    return std::any_of(table.pockets.begin(), table.pockets.end(), [&](const auto& pocket) {
        const Vec2 d = place - pocket.centre;
        const double reach = pocket.radius + margin;
        return d.dot(d) < reach * reach;
    });
}

/// How far the ball is behind the line of a nose, which is at height `nose_height`.
void offer_noses(const Ball& ball, const billiards::TableGeometry& table,
                 const billiards::TableMeasures& measures, Deepest& deepest) {
    const double rise = measures.nose_height - ball.centre.z;
    if (std::abs(rise) >= ball.radius) {
        return;
    }
    const double reach = std::sqrt(ball.radius * ball.radius - rise * rise);
    for (const billiards::CushionFace& face : table.faces) {
        const Vec2 offset = ball.level - face.from;
        const Vec2 along = face.to - face.from;
        const double place = offset.dot(along) / along.dot(along);
        const double distance = offset.dot(face.normal);
        if (place >= 0 && place <= 1 && distance > -measures.cushion_width) {
            deepest.offer(reach - distance, kRoundOff, "a cushion");
        }
    }
    for (const billiards::CushionCorner& corner : table.corners) {
        const Vec2 d = ball.level - corner.centre;
        deepest.offer(reach + corner.radius - std::sqrt(d.dot(d)), kRoundOff, "a cushion");
    }
}

/// Cushions and rails are solid from the cloth up to the rail's top.
void offer_frame(const Ball& ball, const billiards::TableGeometry& table,
                 const billiards::TableMeasures& measures, Deepest& deepest) {
    const Vec2 field(0.5 * measures.length, 0.5 * measures.width);
    const Vec2 beyond(std::abs(ball.level.x) - field.x, std::abs(ball.level.y) - field.y);
    const double farthest = std::max(beyond.x, beyond.y);
    if (farthest < 0 || farthest > measures.cushion_width + measures.rail_width) {
        return;
    }
    // Where a ball can hang in a pocket's jaws, these say whether it fits.
    if (ball.centre.z < 0 || is_over_pocket(ball.level, table, ball.radius)) {
        return;
    }
    deepest.offer(measures.rail_height + ball.radius - ball.centre.z, kPolygon,
                  farthest < measures.cushion_width ? "a cushion" : "a rail");
}

void offer_cloth(const Ball& ball, const billiards::TableGeometry* table,
                 const billiards::TableMeasures& measures, Deepest& deepest) {
    if (ball.centre.z < -ball.radius) {
        return;  // under the table
    }
    const bool is_over =
        table == nullptr ||
        (std::abs(ball.level.x) <= 0.5 * measures.length + measures.cushion_width &&
         std::abs(ball.level.y) <= 0.5 * measures.width + measures.cushion_width &&
         !is_over_pocket(ball.level, *table));
    if (is_over) {
        deepest.offer(ball.radius - ball.centre.z, kRoundOff, "the cloth");
    }
}

std::vector<Aabb> boxes_around_balls(const WorldDescription& world) {
    std::vector<Aabb> boxes;
    for (const Body& body : world.bodies) {
        const auto* sphere = std::get_if<Sphere>(&body.shape);
        if (sphere == nullptr || body.kind != BodyKind::dynamic || !is_finite(body.pose.position)) {
            continue;
        }
        boxes.push_back({body.pose.position, body.pose.position});
        boxes.back().grow(sphere->radius);
    }
    return boxes;
}

bool is_near_any(const billiards::Surface& surface, const std::vector<Aabb>& balls) {
    if (surface.vertices.empty()) {
        return false;
    }
    Aabb bounds{surface.vertices[0], surface.vertices[0]};
    for (const Vec3& vertex : surface.vertices) {
        bounds.extend(vertex);
    }
    return std::any_of(balls.begin(), balls.end(),
                       [&](const Aabb& ball) { return ball.overlaps(bounds); });
}

/// Cushion tops, rails and pockets near balls, as far as their surfaces go.
StaticMesh table_mesh(const billiards::TableGeometry& table, const std::vector<Aabb>& balls,
                      std::vector<std::string>& names) {
    StaticMesh mesh;
    for (const billiards::Surface& surface : table.surfaces) {
        using billiards::SurfacePart;
        std::string name;
        if (surface.part == SurfacePart::cushion) {
            name = "a cushion";
        }
        if (surface.part == SurfacePart::rail) {
            name = "a rail";
        }
        if (surface.part == SurfacePart::pocket_liner ||
            surface.part == SurfacePart::pocket_floor) {
            name = "a pocket";
        }
        if (name.empty() || !is_near_any(surface, balls)) {
            continue;
        }
        mesh.add(surface.vertices, surface.triangles, static_cast<std::uint32_t>(names.size()));
        names.push_back(name);
    }
    return mesh;
}

StaticMesh scenery_mesh(const WorldDescription& world, std::vector<std::string>& names) {
    StaticMesh mesh;
    for (const Body& body : world.bodies) {
        const auto* triangles = std::get_if<TriangleMesh>(&body.shape);
        if (body.kind != BodyKind::fixed || triangles == nullptr) {
            continue;
        }
        std::vector<Vec3> vertices = triangles->vertices;
        for (Vec3& v : vertices) {
            v = body.pose.position + to_world(body.pose.orientation, v);
        }
        mesh.add(std::move(vertices), triangles->triangles,
                 static_cast<std::uint32_t>(names.size()));
        names.push_back("'" + body.name + "'");
    }
    return mesh;
}

void offer_mesh(const Ball& ball, const StaticMesh& mesh, const std::vector<std::string>& names,
                Deepest& deepest) {
    for (const SurfaceContact& contact : mesh.contacts(ball.centre, ball.radius, 0)) {
        deepest.offer(contact.depth, kPolygon, names[contact.surface]);
    }
}

void offer_solids(const Ball& ball, const WorldDescription& world, Deepest& deepest) {
    for (const Body& body : world.bodies) {
        const std::optional<SolidShape> solid = solid_shape(body.shape);
        if (!solid) {
            continue;
        }
        const Pose pose{body.pose.position, body.pose.orientation * solid->principal};
        const SurfaceContact contact =
            convex_contact(*solid->shape, pose, ball.centre, ball.radius);
        deepest.offer(contact.depth, kRoundOff, "'" + body.name + "'");
    }
}

}  // namespace

std::string StartOverlap::sentence() const {
    return fmt::format("reaches {:.2f} mm into {}", std::max(depth * 1e3, 0.01), other);
}

std::vector<StartOverlap> find_start_overlaps(const WorldDescription& world,
                                              const billiards::TableGeometry* table) {
    std::vector<std::string> table_names;
    std::vector<std::string> scenery_names;
    const StaticMesh drawn = table != nullptr
                                 ? table_mesh(*table, boxes_around_balls(world), table_names)
                                 : StaticMesh();
    const StaticMesh scenery = scenery_mesh(world, scenery_names);
    std::vector<StartOverlap> overlaps;
    for (const Body& body : world.bodies) {
        const auto* sphere = std::get_if<Sphere>(&body.shape);
        if (sphere == nullptr || body.kind != BodyKind::dynamic || !is_finite(body.pose.position)) {
            continue;
        }
        const Vec3& centre = body.pose.position;
        const Ball ball{centre, sphere->radius, {centre.x, centre.y}};
        Deepest deepest;
        if (world.table) {
            offer_cloth(ball, table, *world.table, deepest);
        }
        if (table != nullptr) {
            offer_noses(ball, *table, *world.table, deepest);
            offer_frame(ball, *table, *world.table, deepest);
            offer_mesh(ball, drawn, table_names, deepest);
        }
        if (world.floor_height) {
            deepest.offer(ball.radius - (centre.z - *world.floor_height), kRoundOff, "the floor");
        }
        offer_solids(ball, world, deepest);
        offer_mesh(ball, scenery, scenery_names, deepest);
        if (auto overlap = deepest.of(body.name)) {
            overlaps.push_back(std::move(*overlap));
        }
    }
    return overlaps;
}

}  // namespace carom::sim
