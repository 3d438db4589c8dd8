#include "sim/scheduler/contact_finder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/spatial/convex_contacts.h"
#include "sim/spatial/mesh_contacts.h"

namespace carom::sim {
namespace {

/// Gaps up to this (m) count as contact, so that a ball at rest does not keep losing contact.
constexpr double kMargin = 1e-5;

SurfaceContact from_ode(const ode::BoxContact& contact) {
    return {contact.point, contact.normal, contact.depth, 0};
}

SurfaceContact from_convex(const ConvexContact& contact) {
    return {contact.point, contact.normal, contact.depth, 0};
}

}  // namespace

std::vector<Placement> placements_of(std::span<const MovingBody> bodies) {
    std::vector<Placement> placed;
    placed.reserve(bodies.size());
    for (const MovingBody& body : bodies) {
        placed.push_back({body.state, body.mode});
    }
    return placed;
}

std::vector<BodyContact> ContactFinder::find(std::span<const MovingBody> bodies,
                                             std::span<const Placement> placed) const {
    std::vector<BodyContact> found;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!placed[i].is_collidable()) {
            continue;
        }
        const Placed first{static_cast<int>(i), bodies[i], placed[i].state};
        const bool is_kinematic = first.body.is_kinematic();
        if (placed[i].is_in_solver() && !is_kinematic) {
            if (first.body.is_ball()) {
                find_for_ball(first, found);
            } else {
                find_for_solid(first, found);
            }
        }
        for (std::size_t j = i + 1; j < bodies.size(); ++j) {
            const bool can_move = !is_kinematic || !bodies[j].is_kinematic();
            if (placed[j].is_collidable() && can_move &&
                (placed[i].is_in_solver() || placed[j].is_in_solver())) {
                find_between(first, {static_cast<int>(j), bodies[j], placed[j].state}, found);
            }
        }
    }
    return found;
}

SurfaceInfo ContactFinder::info(int other) const {
    if (other == kCloth) {
        return {"cloth", MaterialId::cloth};
    }
    if (other == kFloor) {
        return {"floor", MaterialId::floor};
    }
    if (other <= kFirstFixed) {
        return environment_.spheres[static_cast<std::size_t>(kFirstFixed - other)].info;
    }
    return environment_.surfaces[static_cast<std::size_t>(kFirstSurface - other)];
}

void ContactFinder::add(const Placed& placed, int other, MaterialId other_material,
                        const SurfaceContact& contact, std::vector<BodyContact>& found) const {
    const ContactNumbers& numbers =
        environment_.contacts.between(placed.body.material, other_material);
    BodyContact result;
    result.other = other;
    result.contact = {placed.number,
                      std::max(other, -1),
                      contact.point,
                      contact.normal,
                      contact.depth,
                      numbers.restitution,
                      numbers.friction,
                      numbers.rolling_lever * placed.body.radius,
                      numbers.spinning_lever * placed.body.radius};
    found.push_back(result);
}

void ContactFinder::find_for_ball(const Placed& ball, std::vector<BodyContact>& found) const {
    const Vec3& centre = ball.state.position;
    const double radius = ball.body.radius;
    if (environment_.has_cloth && centre.z > -radius) {
        const int pocket = environment_.pocket_below(centre);
        SurfaceContact contact;
        contact.depth = -1;
        if (pocket >= 0) {
            contact = environment_.collided->rims[static_cast<std::size_t>(pocket)].contact(centre,
                                                                                            radius);
        } else if (environment_.is_over_cloth(centre)) {
            contact = {Vec3(centre.x, centre.y, 0), Vec3(0, 0, 1), radius - centre.z, 0};
        }
        if (contact.depth > -kMargin) {
            add(ball, kCloth, MaterialId::cloth, contact, found);
        }
    }
    if (environment_.floor_height) {
        const double height = centre.z - *environment_.floor_height;
        if (radius - height > -kMargin) {
            add(ball, kFloor, MaterialId::floor,
                {Vec3(centre.x, centre.y, *environment_.floor_height), Vec3(0, 0, 1),
                 radius - height, 0},
                found);
        }
    }
    for (const StaticMesh* mesh : {&environment_.collided->mesh, &environment_.scenery_mesh}) {
        for (const SurfaceContact& contact : mesh->contacts(centre, radius, kMargin)) {
            add(ball, kFirstSurface - static_cast<int>(contact.surface),
                environment_.surfaces[contact.surface].material, contact, found);
        }
    }
    for (const FixedSolid& solid : environment_.solids) {
        if (solid.has_mesh) {
            continue;
        }
        const SurfaceContact contact = convex_contact(*solid.shape, solid.pose, centre, radius);
        if (contact.depth > -kMargin) {
            add(ball, kFirstSurface - static_cast<int>(solid.surface), solid.info.material, contact,
                found);
        }
    }
    for (std::size_t i = 0; i < environment_.spheres.size(); ++i) {
        const FixedSphere& sphere = environment_.spheres[i];
        const Vec3 d = centre - sphere.centre;
        const double distance = std::sqrt(d.dot(d));
        const double depth = radius + sphere.radius - distance;
        if (depth > -kMargin && distance > 1e-9) {
            add(ball, kFirstFixed - static_cast<int>(i), sphere.info.material,
                {sphere.centre + d * (sphere.radius / distance), d / distance, depth, 0}, found);
        }
    }
}

void ContactFinder::find_for_solid(const Placed& solid, std::vector<BodyContact>& found) const {
    find_on_ground(solid, found);
    Aabb bounds = bounds_of(solid.shape());
    bounds.grow(ode::kBoxMargin);
    for (const FixedSolid& fixed : environment_.solids) {
        if (!bounds.overlaps(fixed.bounds)) {
            continue;
        }
        for (const SurfaceContact& contact :
             solid_contacts(solid.shape(), {fixed.shape.get(), fixed.pose})) {
            add(solid, kFirstSurface - static_cast<int>(fixed.surface), fixed.info.material,
                contact, found);
        }
    }
    if (solid.body.is_box()) {
        find_box_meshes(solid, bounds, found);
    } else {
        find_meshes(solid, bounds, found);
    }
    for (std::size_t i = 0; i < environment_.spheres.size(); ++i) {
        const FixedSphere& sphere = environment_.spheres[i];
        SurfaceContact contact =
            convex_contact(*solid.body.shape, solid.shape().pose, sphere.centre, sphere.radius);
        contact.normal = -contact.normal;
        if (contact.depth > -kMargin) {
            add(solid, kFirstFixed - static_cast<int>(i), sphere.info.material, contact, found);
        }
    }
}

void ContactFinder::find_box_meshes(const Placed& box, const Aabb& bounds,
                                    std::vector<BodyContact>& found) const {
    std::vector<ode::BoxContact> contacts;
    for (const BoxObstacle& obstacle : environment_.box_obstacles) {
        if (!bounds.overlaps(obstacle.bounds)) {
            continue;
        }
        contacts.clear();
        obstacle.surface.collide(box.body.shape->half_size() * 2, box.shape().pose, contacts);
        for (const ode::BoxContact& contact : contacts) {
            add(box, kFirstSurface - static_cast<int>(obstacle.number), obstacle.info.material,
                from_ode(contact), found);
        }
    }
}

void ContactFinder::find_meshes(const Placed& solid, const Aabb& bounds,
                                std::vector<BodyContact>& found) const {
    for (const StaticMesh* mesh : {&environment_.collided->mesh, &environment_.scenery_mesh}) {
        for (const SurfaceContact& contact :
             mesh_contacts(solid.shape(), *mesh, bounds, ode::kBoxMargin)) {
            // Solids with flat sides are tested as solids, not as meshes.
            const bool is_solid = std::any_of(
                environment_.solids.begin(), environment_.solids.end(),
                [&](const FixedSolid& fixed) {
                    return mesh == &environment_.scenery_mesh && fixed.surface == contact.surface;
                });
            if (!is_solid) {
                add(solid, kFirstSurface - static_cast<int>(contact.surface),
                    environment_.surfaces[contact.surface].material, contact, found);
            }
        }
    }
}

void ContactFinder::find_on_ground(const Placed& solid, std::vector<BodyContact>& found) const {
    const Vec3 up(0, 0, 1);
    const Quat& turn = solid.state.orientation;
    std::vector<Vec3> points;
    solid.body.shape->resting_points(to_body(turn, -up), points);
    std::vector<ConvexContact> on_cloth;
    std::vector<ConvexContact> on_floor;
    for (const Vec3& point : points) {
        const Vec3 corner = solid.state.position + to_world(turn, point);
        if (environment_.has_cloth && corner.z < ode::kBoxMargin &&
            corner.z > -solid.body.bounding_radius() && environment_.is_over_cloth(corner)) {
            on_cloth.push_back({corner, up, -corner.z});
        }
        if (environment_.floor_height && corner.z - *environment_.floor_height < ode::kBoxMargin) {
            on_floor.push_back({corner, up, *environment_.floor_height - corner.z});
        }
    }
    reduce_contacts(on_cloth);
    reduce_contacts(on_floor);
    for (const ConvexContact& contact : on_cloth) {
        add(solid, kCloth, MaterialId::cloth, from_convex(contact), found);
    }
    for (const ConvexContact& contact : on_floor) {
        add(solid, kFloor, MaterialId::floor, from_convex(contact), found);
    }
}

/// ODE finds the contacts of two boxes, convex_contacts() those of all other pairs.
std::vector<SurfaceContact> ContactFinder::solid_contacts(const PlacedShape& a,
                                                          const PlacedShape& b) {
    std::vector<SurfaceContact> result;
    if (a.shape->is_box() && b.shape->is_box()) {
        std::vector<ode::BoxContact> contacts;
        ode::collide_boxes(a.shape->half_size() * 2, a.pose, b.shape->half_size() * 2, b.pose,
                           contacts);
        for (const ode::BoxContact& contact : contacts) {
            result.push_back(from_ode(contact));
        }
        return result;
    }
    std::vector<ConvexContact> contacts;
    convex_contacts(a, b, ode::kBoxMargin, contacts);
    for (const ConvexContact& contact : contacts) {
        result.push_back(from_convex(contact));
    }
    return result;
}

void ContactFinder::find_between(const Placed& first, const Placed& second,
                                 std::vector<BodyContact>& found) const {
    const Vec3 d = first.state.position - second.state.position;
    const double least_distance =
        first.body.bounding_radius() + second.body.bounding_radius() + ode::kBoxMargin;
    if (d.dot(d) > least_distance * least_distance) {
        return;
    }
    if (first.body.is_ball() && second.body.is_ball()) {
        const double distance = std::sqrt(d.dot(d));
        const double depth = first.body.radius + second.body.radius - distance;
        if (depth > -kMargin && distance > 1e-9) {
            add(first, second.number, second.body.material,
                {second.state.position + d * (second.body.radius / distance), d / distance, depth,
                 0},
                found);
        }
    } else if (first.body.is_ball()) {
        const SurfaceContact contact = convex_contact(*second.body.shape, second.shape().pose,
                                                      first.state.position, first.body.radius);
        if (contact.depth > -kMargin) {
            add(first, second.number, second.body.material, contact, found);
        }
    } else {
        for (const SurfaceContact& contact : solid_contacts(first.shape(), second.shape())) {
            add(first, second.number, second.body.material, contact, found);
        }
    }
}

}  // namespace carom::sim
