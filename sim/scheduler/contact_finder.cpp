#include "sim/scheduler/contact_finder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/scheduler/contact_numbers.h"

namespace carom::sim {
namespace {

/// Gaps up to this (m) count as contact, lest a ball that lies still keeps losing touch.
constexpr double kMargin = 1e-5;

SurfaceContact from_ode(const ode::BoxContact& contact) {
    return {contact.point, contact.normal, contact.depth, 0};
}

Aabb box_bounds(const FixedBox& box) {
    StepBody body;
    body.half_size = box.size * 0.5;
    body.state.position = box.pose.position;
    body.state.orientation = box.pose.orientation;
    return body.bounds();
}

}  // namespace

std::vector<FoundContact> ContactFinder::find(const std::vector<StepBody>& bodies) const {
    std::vector<FoundContact> found;
    const int count = static_cast<int>(bodies.size());
    for (int i = 0; i < count; ++i) {
        const StepBody& body = bodies[static_cast<std::size_t>(i)];
        if (!body.is_in)
            continue;
        if (body.is_awake) {
            if (body.is_ball) {
                find_for_ball(i, body, found);
            } else {
                find_for_box(i, body, found);
            }
        }
        for (int j = i + 1; j < count; ++j) {
            const StepBody& other = bodies[static_cast<std::size_t>(j)];
            if (other.is_in && (body.is_awake || other.is_awake))
                find_between(i, body, j, other, found);
        }
    }
    return found;
}

SurfaceInfo ContactFinder::info(int other) const {
    if (other == kCloth)
        return {"cloth", "cloth"};
    if (other == kFloor)
        return {"floor", "floor"};
    if (other <= kFirstFixed)
        return around_.spheres[static_cast<std::size_t>(kFirstFixed - other)].info;
    return around_.surfaces[static_cast<std::size_t>(kFirstSurface - other)];
}

void ContactFinder::add(int number, const StepBody& body, int other,
                        const std::string& other_material, const SurfaceContact& contact,
                        std::vector<FoundContact>& found) const {
    const ContactNumbers numbers =
        contact_numbers(around_.law, body.material, other_material, body.radius);
    FoundContact result;
    result.other = other;
    result.contact = {number,           std::max(other, -1),   contact.point,
                      contact.normal,   contact.depth,         numbers.restitution,
                      numbers.friction, numbers.rolling_lever, numbers.spinning_lever};
    found.push_back(result);
}

void ContactFinder::find_for_ball(int number, const StepBody& ball,
                                  std::vector<FoundContact>& found) const {
    const Vec3& centre = ball.state.position;
    if (around_.has_cloth && centre.z > -ball.radius) {
        const int pocket = around_.pocket_below(centre);
        SurfaceContact contact;
        contact.depth = -1;
        if (pocket >= 0) {
            contact = around_.rims[static_cast<std::size_t>(pocket)].contact(centre, ball.radius);
        } else if (around_.is_over_cloth(centre)) {
            contact = {Vec3(centre.x, centre.y, 0), Vec3(0, 0, 1), ball.radius - centre.z, 0};
        }
        if (contact.depth > -kMargin)
            add(number, ball, kCloth, "cloth", contact, found);
    }
    if (around_.floor_height) {
        const double height = centre.z - *around_.floor_height;
        if (ball.radius - height > -kMargin)
            add(number, ball, kFloor, "floor",
                {Vec3(centre.x, centre.y, *around_.floor_height), Vec3(0, 0, 1),
                 ball.radius - height, 0},
                found);
    }
    for (const StaticMesh* mesh : {&around_.table_mesh, &around_.scenery_mesh}) {
        for (const SurfaceContact& contact : mesh->contacts(centre, ball.radius, kMargin))
            add(number, ball, kFirstSurface - static_cast<int>(contact.surface),
                around_.surfaces[contact.surface].material, contact, found);
    }
    for (std::size_t i = 0; i < around_.spheres.size(); ++i) {
        const FixedSphere& sphere = around_.spheres[i];
        const Vec3 d = centre - sphere.centre;
        const double distance = std::sqrt(d.dot(d));
        const double depth = ball.radius + sphere.radius - distance;
        if (depth > -kMargin && distance > 1e-9)
            add(number, ball, kFirstFixed - static_cast<int>(i), sphere.info.material,
                {sphere.centre + d * (sphere.radius / distance), d / distance, depth, 0}, found);
    }
}

void ContactFinder::find_for_box(int number, const StepBody& box,
                                 std::vector<FoundContact>& found) const {
    find_level(number, box, found);
    Aabb bounds = box.bounds();
    bounds.grow(ode::kBoxMargin);
    const Pose pose{box.state.position, box.state.orientation};
    std::vector<ode::BoxContact> contacts;
    for (const FixedBox& fixed : around_.boxes) {
        if (!bounds.overlaps(box_bounds(fixed)))
            continue;
        contacts.clear();
        ode::collide_boxes(box.half_size * 2, pose, fixed.size, fixed.pose, contacts);
        for (const ode::BoxContact& contact : contacts)
            add(number, box, kFirstSurface - static_cast<int>(fixed.surface), fixed.info.material,
                from_ode(contact), found);
    }
    for (const BoxObstacle& obstacle : around_.box_obstacles) {
        if (!bounds.overlaps(obstacle.bounds))
            continue;
        contacts.clear();
        obstacle.surface.collide(box.half_size * 2, pose, contacts);
        for (const ode::BoxContact& contact : contacts)
            add(number, box, kFirstSurface - static_cast<int>(obstacle.number),
                obstacle.info.material, from_ode(contact), found);
    }
    for (std::size_t i = 0; i < around_.spheres.size(); ++i) {
        const FixedSphere& sphere = around_.spheres[i];
        SurfaceContact contact = box_contact(box.half_size, pose, sphere.centre, sphere.radius);
        contact.normal = -contact.normal;
        if (contact.depth > -kMargin)
            add(number, box, kFirstFixed - static_cast<int>(i), sphere.info.material, contact,
                found);
    }
}

void ContactFinder::find_level(int number, const StepBody& box,
                               std::vector<FoundContact>& found) const {
    for (int i = 0; i < 8; ++i) {
        const Vec3 corner = corner_of(box, i);
        const Vec3 up(0, 0, 1);
        if (around_.has_cloth && corner.z < ode::kBoxMargin && corner.z > -box.reach() &&
            around_.is_over_cloth(corner))
            add(number, box, kCloth, "cloth", {corner, up, -corner.z, 0}, found);
        if (around_.floor_height && corner.z - *around_.floor_height < ode::kBoxMargin)
            add(number, box, kFloor, "floor", {corner, up, *around_.floor_height - corner.z, 0},
                found);
    }
}

void ContactFinder::find_between(int a, const StepBody& first, int b, const StepBody& second,
                                 std::vector<FoundContact>& found) const {
    const Vec3 d = first.state.position - second.state.position;
    const double reach = first.reach() + second.reach() + ode::kBoxMargin;
    if (d.dot(d) > reach * reach)
        return;
    const Pose pose_a{first.state.position, first.state.orientation};
    const Pose pose_b{second.state.position, second.state.orientation};
    if (first.is_ball && second.is_ball) {
        const double distance = std::sqrt(d.dot(d));
        const double depth = first.radius + second.radius - distance;
        if (depth > -kMargin && distance > 1e-9)
            add(a, first, b, second.material,
                {second.state.position + d * (second.radius / distance), d / distance, depth, 0},
                found);
    } else if (first.is_ball) {
        const SurfaceContact contact =
            box_contact(second.half_size, pose_b, first.state.position, first.radius);
        if (contact.depth > -kMargin)
            add(a, first, b, second.material, contact, found);
    } else {
        std::vector<ode::BoxContact> contacts;
        ode::collide_boxes(first.half_size * 2, pose_a, second.half_size * 2, pose_b, contacts);
        for (const ode::BoxContact& contact : contacts)
            add(a, first, b, second.material, from_ode(contact), found);
    }
}

}  // namespace carom::sim
