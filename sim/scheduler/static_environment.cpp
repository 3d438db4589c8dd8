#include "sim/scheduler/static_environment.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/rigid.h"

namespace carom::sim {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The ball radius for which the table's cushions are drawn: that of the first ball.
double table_ball_radius(const WorldDescription& world) {
    for (const Body& body : world.bodies) {
        const auto* sphere = std::get_if<Sphere>(&body.shape);
        if (sphere != nullptr && body.kind == BodyKind::dynamic && body.material == "ball") {
            return sphere->radius;
        }
    }
    return Sphere{}.radius;
}

struct Triangles {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
};

Triangles box_triangles(const Vec3& size) {
    Triangles box;
    for (int i = 0; i < 8; ++i) {
        box.vertices.emplace_back((i & 1) != 0 ? size.x / 2 : -size.x / 2,
                                  (i & 2) != 0 ? size.y / 2 : -size.y / 2,
                                  (i & 4) != 0 ? size.z / 2 : -size.z / 2);
    }
    box.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return box;
}

/// The triangles that balls can hit, of boxes and hulls.
Triangles flat_sides(const BodyShape& shape) {
    if (const auto* box = std::get_if<Box>(&shape)) {
        return box_triangles(box->size);
    }
    Triangles mesh;
    const auto* points = std::get_if<ConvexHull>(&shape);
    const auto hull = points != nullptr ? convex_hull(points->points) : std::nullopt;
    if (!hull) {
        return mesh;
    }
    mesh.vertices = hull->vertices;
    for (const PolyhedronFace& face : hull->faces) {
        for (std::size_t i = 2; i < face.corners.size(); ++i) {
            mesh.triangles.push_back({face.corners[0], face.corners[i - 1], face.corners[i]});
        }
    }
    return mesh;
}

void place(Triangles& mesh, const Pose& pose) {
    for (Vec3& v : mesh.vertices) {
        v = pose.position + to_world(pose.orientation, v);
    }
}

Aabb bounds_of(const std::vector<Vec3>& vertices) {
    Aabb box{vertices.front(), vertices.front()};
    for (const Vec3& v : vertices) {
        box.extend(v);
    }
    return box;
}

std::shared_ptr<const CollidedTable> no_table() {
    static const auto none = std::make_shared<const CollidedTable>();
    return none;
}

}  // namespace

StaticEnvironment::StaticEnvironment(const WorldDescription& world)
    : gravity(world.gravity),
      law(world.contact_law),
      jaw(world.contact_law.ball_cushion),
      contacts(law),
      collided(no_table()),
      floor_height(world.floor_height) {
    if (gravity.z < 0) {
        downward_gravity = -gravity.z;
        pull = {gravity.x, gravity.y, 0};
    }
    const bool has_boxes =
        std::any_of(world.bodies.begin(), world.bodies.end(), [](const Body& body) {
            return body.kind == BodyKind::dynamic && std::holds_alternative<Box>(body.shape);
        });
    if (world.table) {
        add_table(world, has_boxes);
    }
    add_fixed_bodies(world, has_boxes);
}

void StaticEnvironment::add_table(const WorldDescription& world, bool has_boxes) {
    has_cloth = true;
    has_cushions = world.table->has_cushions;
    has_ball_return = world.table->has_ball_return;
    jaw.restitution *= world.table->jaw_restitution;
    jaw.fall.slope *= world.table->jaw_restitution;
    jaw.fall.least *= world.table->jaw_restitution;
    nose_height = world.table->nose_height;
    cloth_half_extent =
        Vec2(world.table->length, world.table->width) * 0.5 + Vec2(world.table->cushion_width);
    if (!has_cushions) {
        return;
    }
    collided = collided_table(*world.table, table_ball_radius(world));
    for (const CollidedTable::Part& part : collided->parts) {
        const auto number = static_cast<std::uint32_t>(surfaces.size());
        surfaces.push_back({part.material, contacts.id_of(part.material)});
        if (has_boxes) {
            const billiards::Surface& surface = collided->geometry.surfaces[part.surface];
            box_obstacles.push_back({surfaces.back(), number,
                                     ode::TriangleSurface(surface.vertices, surface.triangles),
                                     bounds_of(surface.vertices)});
        }
    }
}

void StaticEnvironment::add_fixed_bodies(const WorldDescription& world, bool has_boxes) {
    for (const Body& body : world.bodies) {
        if (body.kind != BodyKind::fixed) {
            continue;
        }
        const SurfaceInfo info{body.name, contacts.id_of(body.material)};
        if (const auto* sphere = std::get_if<Sphere>(&body.shape)) {
            spheres.push_back({info, body.pose.position, sphere->radius});
            continue;
        }
        const auto number = static_cast<std::uint32_t>(surfaces.size());
        Triangles mesh;
        if (const auto solid = solid_shape(body.shape)) {
            const Pose pose{body.pose.position, body.pose.orientation * solid->principal};
            mesh = flat_sides(body.shape);
            solids.push_back({info, number, solid->shape, pose,
                              bounds_of(PlacedShape{solid->shape.get(), pose}),
                              !mesh.triangles.empty()});
            if (mesh.triangles.empty()) {
                surfaces.push_back(info);
            }
        } else if (const auto* triangles = std::get_if<TriangleMesh>(&body.shape)) {
            mesh = {triangles->vertices, triangles->triangles};
        }
        if (mesh.triangles.empty()) {
            continue;
        }
        place(mesh, body.pose);
        scenery_mesh.add(mesh.vertices, mesh.triangles, number);
        surfaces.push_back(info);
        if (has_boxes && std::holds_alternative<TriangleMesh>(body.shape)) {
            box_obstacles.push_back({info, number,
                                     ode::TriangleSurface(mesh.vertices, mesh.triangles),
                                     bounds_of(mesh.vertices)});
        }
    }
}

bool StaticEnvironment::is_over_cloth(const Vec3& centre) const {
    if (!has_cloth) {
        return false;
    }
    if (!has_cushions) {
        return true;
    }
    return std::abs(centre.x) <= cloth_half_extent.x && std::abs(centre.y) <= cloth_half_extent.y &&
           pocket_below(centre) < 0;
}

int StaticEnvironment::pocket_below(const Vec3& centre) const {
    for (std::size_t i = 0; i < table().pockets.size(); ++i) {
        const billiards::Pocket& pocket = table().pockets[i];
        const Vec2 d = Vec2(centre.x, centre.y) - pocket.centre;
        if (d.dot(d) < pocket.radius * pocket.radius) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

}  // namespace carom::sim
