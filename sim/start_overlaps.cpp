#include "sim/start_overlaps.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "core/finite.h"
#include "core/text.h"
#include "sim/solid_shape.h"
#include "sim/spatial/convex_contacts.h"
#include "sim/spatial/convex_impact_time.h"
#include "sim/spatial/mesh_contacts.h"
#include "sim/spatial/static_mesh.h"

namespace carom::sim {
namespace {

/// A ball this far (m) inside or above a level surface counts as standing on it.
constexpr double kRounding = 1e-6;
/// Round surfaces are approximated by polygons, so overlaps up to this (m) are not reported.
constexpr double kPolygonError = 1e-4;

struct Ball {
    const Body* body = nullptr;
    Vec3 centre{0, 0, 0};
    double radius = 0;
    Vec2 from_above;  // x and y of the centre
};

/// Keeps the deepest overlap found so far.
class DeepestOverlap {
  public:
    void consider(double depth, double tolerance, const std::string& other) {
        if (depth > tolerance && depth > depth_) {
            depth_ = depth;
            other_ = other;
        }
    }
    void append_to(std::vector<StartOverlap>& overlaps, const std::string& body) const {
        if (!other_.empty()) {
            overlaps.push_back({body, other_, depth_});
        }
    }

  private:
    double depth_ = 0;
    std::string other_;
};

bool is_over_pocket(const Vec2& position, const billiards::TableGeometry& table,
                    double margin = 0) {
    return std::any_of(table.pockets.begin(), table.pockets.end(), [&](const auto& pocket) {
        const Vec2 d = position - pocket.centre;
        const double distance = pocket.radius + margin;
        return d.dot(d) < distance * distance;
    });
}

/// Overlaps with the noses of the cushions, which are at height `nose_height`.
void check_noses(const Ball& ball, const billiards::TableGeometry& table,
                 const billiards::TableMeasures& measures, DeepestOverlap& deepest) {
    const double rise = measures.nose_height - ball.centre.z;
    if (std::abs(rise) >= ball.radius) {
        return;
    }
    const double contact_distance = std::sqrt(ball.radius * ball.radius - rise * rise);
    for (const billiards::CushionFace& face : table.faces) {
        const Vec2 offset = ball.from_above - face.from;
        const Vec2 along = face.to - face.from;
        const double fraction = offset.dot(along) / along.dot(along);
        const double distance = offset.dot(face.normal);
        if (fraction >= 0 && fraction <= 1 && distance > -measures.cushion_width) {
            deepest.consider(contact_distance - distance, kRounding, "a cushion");
        }
    }
    for (const billiards::CushionCorner& corner : table.corners) {
        const Vec2 d = ball.from_above - corner.centre;
        deepest.consider(contact_distance + corner.radius - std::sqrt(d.dot(d)), kRounding,
                         "a cushion");
    }
}

/// Overlaps with the cushions and rails as solids from the cloth up to the rail's top.
void check_cushions_and_rails(const Ball& ball, const billiards::TableGeometry& table,
                              const billiards::TableMeasures& measures, DeepestOverlap& deepest) {
    const Vec2 field(0.5 * measures.length, 0.5 * measures.width);
    const Vec2 beyond(std::abs(ball.from_above.x) - field.x, std::abs(ball.from_above.y) - field.y);
    const double farthest = std::max(beyond.x, beyond.y);
    if (farthest < 0 || farthest > measures.cushion_width + measures.rail_width) {
        return;
    }
    // A ball may hang in a pocket's jaws; check_noses and check_mesh decide whether it fits.
    if (ball.centre.z < 0 || is_over_pocket(ball.from_above, table, ball.radius)) {
        return;
    }
    deepest.consider(measures.rail_height + ball.radius - ball.centre.z, kPolygonError,
                     farthest < measures.cushion_width ? "a cushion" : "a rail");
}

void check_cloth(const Ball& ball, const billiards::TableGeometry* table,
                 const billiards::TableMeasures& measures, DeepestOverlap& deepest) {
    if (ball.centre.z < -ball.radius) {
        return;  // under the table
    }
    const bool is_over =
        table == nullptr ||
        (std::abs(ball.from_above.x) <= 0.5 * measures.length + measures.cushion_width &&
         std::abs(ball.from_above.y) <= 0.5 * measures.width + measures.cushion_width &&
         !is_over_pocket(ball.from_above, *table));
    if (is_over) {
        deepest.consider(ball.radius - ball.centre.z, kRounding, "the cloth");
    }
}

bool is_near_any(const billiards::Surface& surface, const std::vector<Aabb>& bodies) {
    if (surface.vertices.empty()) {
        return false;
    }
    Aabb bounds{surface.vertices[0], surface.vertices[0]};
    for (const Vec3& vertex : surface.vertices) {
        bounds.extend(vertex);
    }
    return std::any_of(bodies.begin(), bodies.end(),
                       [&](const Aabb& body) { return body.overlaps(bounds); });
}

/// Surfaces, and what each is called in a message.
struct NamedMesh {
    StaticMesh mesh;
    std::vector<std::string> names;

    void add(std::vector<Vec3> vertices, std::vector<MeshTriangle> triangles, std::string name) {
        mesh.add(std::move(vertices), std::move(triangles),
                 static_cast<std::uint32_t>(names.size()));
        names.push_back(std::move(name));
    }
};

/// The surfaces of cushion tops, rails and pockets near bodies.
NamedMesh table_mesh(const billiards::TableGeometry& table, const std::vector<Aabb>& bodies) {
    NamedMesh mesh;
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
        if (name.empty() || !is_near_any(surface, bodies)) {
            continue;
        }
        mesh.add(surface.vertices, surface.triangles, name);
    }
    return mesh;
}

NamedMesh scenery_mesh(const WorldDescription& world) {
    NamedMesh mesh;
    for (const Body& body : world.bodies) {
        const auto* triangles = std::get_if<TriangleMesh>(&body.shape);
        if (body.kind != BodyKind::fixed || triangles == nullptr) {
            continue;
        }
        std::vector<Vec3> vertices = triangles->vertices;
        for (Vec3& v : vertices) {
            v = body.pose.position + to_world(body.pose.orientation, v);
        }
        mesh.add(std::move(vertices), triangles->triangles, "'" + body.name + "'");
    }
    return mesh;
}

void check_mesh(const Ball& ball, const NamedMesh& surfaces, DeepestOverlap& deepest) {
    for (const SurfaceContact& contact : surfaces.mesh.contacts(ball.centre, ball.radius, 0)) {
        deepest.consider(contact.depth, kPolygonError, surfaces.names[contact.surface]);
    }
}

/// A body that is neither a ball nor a mesh.
struct Solid {
    const Body* body = nullptr;
    SolidShape solid;
    PlacedShape placed;
};

/// Where the body is at the start, by its path if it has one.
Pose start_of(const Body& body) {
    if (!body.path) {
        return body.pose;
    }
    const MotionState start = body.path->track->sample(0);
    return {start.position + to_world(start.orientation, body.path->centre), start.orientation};
}

std::vector<Solid> solids_of(const WorldDescription& world) {
    std::vector<Solid> solids;
    for (const Body& body : world.bodies) {
        std::optional<SolidShape> solid = solid_shape(body.shape);
        const Pose start = start_of(body);
        if (solid && is_finite(start.position)) {
            const Pose pose{start.position, start.orientation * solid->principal};
            const ConvexShape* shape = solid->shape.get();
            solids.push_back({&body, std::move(*solid), {shape, pose}});
        }
    }
    return solids;
}

/// False if the solid is certainly apart from a sphere. Without this the cost of many bodies would
/// be that of their names.
bool is_near(const PlacedShape& solid, const Vec3& centre, double radius) {
    const Vec3 apart = solid.pose.position - centre;
    const double reach = solid.shape->bounding_radius() + radius;
    return apart.dot(apart) < reach * reach;
}

void check_solids(const Ball& ball, const std::vector<Solid>& solids, DeepestOverlap& deepest) {
    for (const Solid& solid : solids) {
        if (is_near(solid.placed, ball.centre, ball.radius)) {
            const Contact contact =
                convex_contact(*solid.placed.shape, solid.placed.pose, ball.centre, ball.radius);
            deepest.consider(contact.depth, kRounding, "'" + solid.body->name + "'");
        }
    }
}

void check_pair(const PlacedShape& a, const PlacedShape& b, const std::string& name_of_b,
                DeepestOverlap& deepest) {
    std::vector<Contact> contacts;
    convex_contacts(a, b, 0, contacts);
    for (const Contact& contact : contacts) {
        deepest.consider(contact.depth, kPolygonError, name_of_b);
    }
}

void check_mesh(const PlacedShape& solid, const NamedMesh& surfaces, DeepestOverlap& deepest) {
    for (const SurfaceContact& contact : mesh_contacts(solid, surfaces.mesh, bounds_of(solid), 0)) {
        deepest.consider(contact.depth, kPolygonError, surfaces.names[contact.surface]);
    }
}

/// Overlaps with the slate, which has holes, and with the rails around the cushions.
void check_table(const PlacedShape& solid, const billiards::TableGeometry* table,
                 const billiards::TableMeasures& measures, DeepestOverlap& deepest) {
    const Vec3 low = solid.support({0, 0, -1});
    const bool is_under_table = solid.support({0, 0, 1}).z <= 0;
    if (table == nullptr) {
        return deepest.consider(is_under_table ? 0 : -low.z, kPolygonError, "the cloth");
    }
    const Vec2 outside(0.5 * measures.length + measures.cushion_width,
                       0.5 * measures.width + measures.cushion_width);
    const Vec2 place(low.x, low.y);
    if (!is_under_table && std::abs(place.x) <= outside.x && std::abs(place.y) <= outside.y &&
        !is_over_pocket(place, *table)) {
        deepest.consider(-low.z, kPolygonError, "the cloth");
    }
    const Vec2 centre(solid.pose.position.x, solid.pose.position.y);
    if (is_over_pocket(centre, *table, solid.shape->bounding_radius())) {
        return;
    }
    const double half_rail = 0.5 * measures.rail_width;
    for (const double side : {-1.0, 1.0}) {
        const ConvexShape across = ConvexShape::box(
            {half_rail, outside.y + measures.rail_width, 0.5 * measures.rail_height});
        const ConvexShape along = ConvexShape::box(
            {outside.x + measures.rail_width, half_rail, 0.5 * measures.rail_height});
        const double height = 0.5 * measures.rail_height;
        const PlacedShape end{&across, {{side * (outside.x + half_rail), 0, height}, Quat()}};
        const PlacedShape edge{&along, {{0, side * (outside.y + half_rail), height}, Quat()}};
        check_pair(solid, end, "a rail", deepest);
        check_pair(solid, edge, "a rail", deepest);
    }
}

/// The moving solids before `index`, and all others that move by keys or stand still.
void check_solids(const std::vector<Solid>& solids, std::size_t index, DeepestOverlap& deepest) {
    for (std::size_t i = 0; i < solids.size(); ++i) {
        const Body& other = *solids[i].body;
        const bool is_other = i < index || other.kind != BodyKind::dynamic;
        const PlacedShape& placed = solids[i].placed;
        if (is_other &&
            is_near(solids[index].placed, placed.pose.position, placed.shape->bounding_radius())) {
            check_pair(solids[index].placed, solids[i].placed, "'" + other.name + "'", deepest);
        }
    }
}

/// The world with only the fixed bodies and the ball that the event puts down, where it puts it;
/// without the ball if the world has none of that name.
WorldDescription world_with_placed_ball(const WorldDescription& world, const ForceEvent& event,
                                        const PlaceBall& place) {
    WorldDescription placed = world;
    placed.events.clear();
    placed.bodies.clear();
    for (const Body& body : world.bodies) {
        const auto* sphere = std::get_if<Sphere>(&body.shape);
        if (body.kind == BodyKind::fixed) {
            placed.bodies.push_back(body);
        } else if (body.name == event.object && sphere != nullptr) {
            placed.bodies.push_back(body);
            placed.bodies.back().pose.position = {place.at.x, place.at.y, sphere->radius};
        }
    }
    return placed;
}

/// Why a ball cannot lie there; empty if it can.
std::string place_problem(const WorldDescription& world, const ForceEvent& event,
                          const PlaceBall& place, const billiards::TableGeometry* table) {
    if (table != nullptr && (std::abs(place.at.x) > 0.5 * world.table->length ||
                             std::abs(place.at.y) > 0.5 * world.table->width)) {
        return "is not on the table";
    }
    if (table != nullptr && is_over_pocket(place.at, *table)) {
        return "is over a pocket";
    }
    const auto overlaps = find_start_overlaps(world_with_placed_ball(world, event, place), table);
    return overlaps.empty() ? std::string() : overlaps[0].sentence();
}

}  // namespace

std::string StartOverlap::sentence() const {
    return "overlaps " + other + " by " + millimetres_text(std::max(depth, 1e-5));
}

std::vector<StartOverlap> find_start_overlaps(const WorldDescription& world,
                                              const billiards::TableGeometry* table) {
    const std::vector<Solid> solids = solids_of(world);
    std::vector<Ball> balls;
    std::vector<Aabb> bounds;
    for (const Body& body : world.bodies) {
        const auto* sphere = std::get_if<Sphere>(&body.shape);
        if (sphere != nullptr && body.kind == BodyKind::dynamic && is_finite(body.pose.position)) {
            const Vec3& centre = body.pose.position;
            balls.push_back({&body, centre, sphere->radius, {centre.x, centre.y}});
            bounds.push_back({centre, centre});
            bounds.back().grow(sphere->radius);
        }
    }
    for (const Solid& solid : solids) {
        if (solid.body->kind == BodyKind::dynamic) {
            bounds.push_back(bounds_of(solid.placed));
        }
    }
    const NamedMesh surfaces = table != nullptr ? table_mesh(*table, bounds) : NamedMesh();
    const NamedMesh scenery = scenery_mesh(world);
    std::vector<StartOverlap> overlaps;
    for (const Ball& ball : balls) {
        DeepestOverlap deepest;
        if (world.table) {
            check_cloth(ball, table, *world.table, deepest);
        }
        if (table != nullptr) {
            check_noses(ball, *table, *world.table, deepest);
            check_cushions_and_rails(ball, *table, *world.table, deepest);
        }
        if (world.floor_height) {
            deepest.consider(ball.radius - (ball.centre.z - *world.floor_height), kRounding,
                             "the floor");
        }
        check_solids(ball, solids, deepest);
        check_mesh(ball, surfaces, deepest);
        check_mesh(ball, scenery, deepest);
        deepest.append_to(overlaps, ball.body->name);
    }
    for (std::size_t i = 0; i < solids.size(); ++i) {
        if (solids[i].body->kind != BodyKind::dynamic) {
            continue;
        }
        const PlacedShape& solid = solids[i].placed;
        DeepestOverlap deepest;
        check_solids(solids, i, deepest);
        check_mesh(solid, surfaces, deepest);
        check_mesh(solid, scenery, deepest);
        if (world.table) {
            check_table(solid, table, *world.table, deepest);
        }
        if (world.floor_height) {
            deepest.consider(*world.floor_height - solid.support({0, 0, -1}).z, kPolygonError,
                             "the floor");
        }
        deepest.append_to(overlaps, solids[i].body->name);
    }
    return overlaps;
}

std::vector<Diagnostic> find_place_problems(const WorldDescription& world,
                                            const billiards::TableGeometry* table) {
    std::vector<Diagnostic> problems;
    for (std::size_t i = 0; i < world.events.size(); ++i) {
        const ForceEvent& event = world.events[i];
        const auto* place = std::get_if<PlaceBall>(&event.action);
        if (place == nullptr || !std::isfinite(place->at.x + place->at.y)) {
            continue;
        }
        const std::string problem = place_problem(world, event, *place, table);
        if (!problem.empty()) {
            problems.push_back(
                {Subject::event(i), "spot",
                 fmt::format("event {} on '{}': its place {}", i + 1, event.object, problem)});
        }
    }
    return problems;
}

}  // namespace carom::sim
