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

std::vector<BodyContact> ContactFinder::find(const std::vector<StepBody>& bodies) const {
    std::vector<BodyContact> found;
    const int count = static_cast<int>(bodies.size());
    for (int i = 0; i < count; ++i) {
        const StepBody& body = bodies[static_cast<std::size_t>(i)];
        if (!body.is_in_ode) {
            continue;
        }
        if (body.is_awake && !body.is_kinematic()) {
            if (body.is_ball) {
                find_for_ball(i, body, found);
            } else {
                find_for_solid(i, body, found);
            }
        }
        for (int j = i + 1; j < count; ++j) {
            const StepBody& other = bodies[static_cast<std::size_t>(j)];
            const bool can_move = !body.is_kinematic() || !other.is_kinematic();
            if (other.is_in_ode && can_move && (body.is_awake || other.is_awake)) {
                find_between(i, body, j, other, found);
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

void ContactFinder::add(int number, const StepBody& body, int other, MaterialId other_material,
                        const SurfaceContact& contact, std::vector<BodyContact>& found) const {
    const ContactNumbers& numbers = environment_.contacts.between(body.material, other_material);
    BodyContact result;
    result.other = other;
    result.contact = {number,
                      std::max(other, -1),
                      contact.point,
                      contact.normal,
                      contact.depth,
                      numbers.restitution,
                      numbers.friction,
                      numbers.rolling_lever * body.radius,
                      numbers.spinning_lever * body.radius};
    found.push_back(result);
}

void ContactFinder::find_for_ball(int number, const StepBody& ball,
                                  std::vector<BodyContact>& found) const {
    const Vec3& centre = ball.state.position;
    if (environment_.has_cloth && centre.z > -ball.radius) {
        const int pocket = environment_.pocket_below(centre);
        SurfaceContact contact;
        contact.depth = -1;
        if (pocket >= 0) {
            contact = environment_.collided->rims[static_cast<std::size_t>(pocket)].contact(
                centre, ball.radius);
        } else if (environment_.is_over_cloth(centre)) {
            contact = {Vec3(centre.x, centre.y, 0), Vec3(0, 0, 1), ball.radius - centre.z, 0};
        }
        if (contact.depth > -kMargin) {
            add(number, ball, kCloth, MaterialId::cloth, contact, found);
        }
    }
    if (environment_.floor_height) {
        const double height = centre.z - *environment_.floor_height;
        if (ball.radius - height > -kMargin) {
            add(number, ball, kFloor, MaterialId::floor,
                {Vec3(centre.x, centre.y, *environment_.floor_height), Vec3(0, 0, 1),
                 ball.radius - height, 0},
                found);
        }
    }
    for (const StaticMesh* mesh : {&environment_.collided->mesh, &environment_.scenery_mesh}) {
        for (const SurfaceContact& contact : mesh->contacts(centre, ball.radius, kMargin)) {
            add(number, ball, kFirstSurface - static_cast<int>(contact.surface),
                environment_.surfaces[contact.surface].material, contact, found);
        }
    }
    for (const FixedSolid& solid : environment_.solids) {
        if (solid.has_mesh) {
            continue;
        }
        const SurfaceContact contact =
            convex_contact(*solid.shape, solid.pose, centre, ball.radius);
        if (contact.depth > -kMargin) {
            add(number, ball, kFirstSurface - static_cast<int>(solid.surface), solid.info.material,
                contact, found);
        }
    }
    for (std::size_t i = 0; i < environment_.spheres.size(); ++i) {
        const FixedSphere& sphere = environment_.spheres[i];
        const Vec3 d = centre - sphere.centre;
        const double distance = std::sqrt(d.dot(d));
        const double depth = ball.radius + sphere.radius - distance;
        if (depth > -kMargin && distance > 1e-9) {
            add(number, ball, kFirstFixed - static_cast<int>(i), sphere.info.material,
                {sphere.centre + d * (sphere.radius / distance), d / distance, depth, 0}, found);
        }
    }
}

void ContactFinder::find_for_solid(int number, const StepBody& body,
                                   std::vector<BodyContact>& found) const {
    find_on_ground(number, body, found);
    Aabb bounds = body.bounds();
    bounds.grow(ode::kBoxMargin);
    for (const FixedSolid& solid : environment_.solids) {
        if (!bounds.overlaps(solid.bounds)) {
            continue;
        }
        for (const SurfaceContact& contact :
             solid_contacts(body.placed(), {solid.shape.get(), solid.pose})) {
            add(number, body, kFirstSurface - static_cast<int>(solid.surface), solid.info.material,
                contact, found);
        }
    }
    if (body.is_box()) {
        find_box_meshes(number, body, bounds, found);
    } else {
        find_meshes(number, body, bounds, found);
    }
    for (std::size_t i = 0; i < environment_.spheres.size(); ++i) {
        const FixedSphere& sphere = environment_.spheres[i];
        SurfaceContact contact =
            convex_contact(*body.shape, body.placed().pose, sphere.centre, sphere.radius);
        contact.normal = -contact.normal;
        if (contact.depth > -kMargin) {
            add(number, body, kFirstFixed - static_cast<int>(i), sphere.info.material, contact,
                found);
        }
    }
}

void ContactFinder::find_box_meshes(int number, const StepBody& box, const Aabb& bounds,
                                    std::vector<BodyContact>& found) const {
    std::vector<ode::BoxContact> contacts;
    for (const BoxObstacle& obstacle : environment_.box_obstacles) {
        if (!bounds.overlaps(obstacle.bounds)) {
            continue;
        }
        contacts.clear();
        obstacle.surface.collide(box.shape->half_size() * 2, box.placed().pose, contacts);
        for (const ode::BoxContact& contact : contacts) {
            add(number, box, kFirstSurface - static_cast<int>(obstacle.number),
                obstacle.info.material, from_ode(contact), found);
        }
    }
}

void ContactFinder::find_meshes(int number, const StepBody& body, const Aabb& bounds,
                                std::vector<BodyContact>& found) const {
    for (const StaticMesh* mesh : {&environment_.collided->mesh, &environment_.scenery_mesh}) {
        for (const SurfaceContact& contact :
             mesh_contacts(body.placed(), *mesh, bounds, ode::kBoxMargin)) {
            // Solids with flat sides are tested as solids, not as meshes.
            const bool is_solid = std::any_of(
                environment_.solids.begin(), environment_.solids.end(),
                [&](const FixedSolid& solid) {
                    return mesh == &environment_.scenery_mesh && solid.surface == contact.surface;
                });
            if (!is_solid) {
                add(number, body, kFirstSurface - static_cast<int>(contact.surface),
                    environment_.surfaces[contact.surface].material, contact, found);
            }
        }
    }
}

void ContactFinder::find_on_ground(int number, const StepBody& body,
                                   std::vector<BodyContact>& found) const {
    const Vec3 up(0, 0, 1);
    const Quat& turn = body.state.orientation;
    std::vector<Vec3> points;
    body.shape->resting_points(to_body(turn, -up), points);
    std::vector<ConvexContact> on_cloth;
    std::vector<ConvexContact> on_floor;
    for (const Vec3& point : points) {
        const Vec3 corner = body.state.position + to_world(turn, point);
        if (environment_.has_cloth && corner.z < ode::kBoxMargin &&
            corner.z > -body.bounding_radius() && environment_.is_over_cloth(corner)) {
            on_cloth.push_back({corner, up, -corner.z});
        }
        if (environment_.floor_height && corner.z - *environment_.floor_height < ode::kBoxMargin) {
            on_floor.push_back({corner, up, *environment_.floor_height - corner.z});
        }
    }
    reduce_contacts(on_cloth);
    reduce_contacts(on_floor);
    for (const ConvexContact& contact : on_cloth) {
        add(number, body, kCloth, MaterialId::cloth, from_convex(contact), found);
    }
    for (const ConvexContact& contact : on_floor) {
        add(number, body, kFloor, MaterialId::floor, from_convex(contact), found);
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

void ContactFinder::find_between(int a, const StepBody& first, int b, const StepBody& second,
                                 std::vector<BodyContact>& found) const {
    const Vec3 d = first.state.position - second.state.position;
    const double least_distance =
        first.bounding_radius() + second.bounding_radius() + ode::kBoxMargin;
    if (d.dot(d) > least_distance * least_distance) {
        return;
    }
    if (first.is_ball && second.is_ball) {
        const double distance = std::sqrt(d.dot(d));
        const double depth = first.radius + second.radius - distance;
        if (depth > -kMargin && distance > 1e-9) {
            add(a, first, b, second.material,
                {second.state.position + d * (second.radius / distance), d / distance, depth, 0},
                found);
        }
    } else if (first.is_ball) {
        const SurfaceContact contact =
            convex_contact(*second.shape, second.placed().pose, first.state.position, first.radius);
        if (contact.depth > -kMargin) {
            add(a, first, b, second.material, contact, found);
        }
    } else {
        for (const SurfaceContact& contact : solid_contacts(first.placed(), second.placed())) {
            add(a, first, b, second.material, contact, found);
        }
    }
}

}  // namespace carom::sim
