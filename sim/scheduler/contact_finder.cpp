#include "sim/scheduler/contact_finder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/numeric/tolerances.h"
#include "sim/scheduler/impact_group.h"
#include "sim/spatial/convex_contacts.h"
#include "sim/spatial/mesh_contacts.h"

namespace carom::sim {
namespace {

/// A cylinder or capsule does not roll on an end if the normal deviates from its axis by less than
/// this sine.
constexpr double kMinEndSlope = 1e-3;

}  // namespace

std::vector<Placement> placements_of(std::span<const MovingBody> bodies) {
    std::vector<Placement> placed;
    placed.reserve(bodies.size());
    for (const MovingBody& body : bodies) {
        placed.push_back({body.state, body.mode});
    }
    return placed;
}

const std::vector<BodyContact>& ContactFinder::find(std::span<const MovingBody> bodies,
                                                    std::span<const Placement> placed) {
    const auto is_same = [](const Placement& known, const Placement& now) {
        return known.mode == now.mode && known.state.position == now.state.position &&
               known.state.orientation == now.state.orientation;
    };
    if (!std::ranges::equal(last_placed_, placed, is_same)) {
        last_placed_.assign(placed.begin(), placed.end());
        last_found_ = find_within(0, bodies, placed);
    }
    return last_found_;
}

std::vector<BodyContact> ContactFinder::find_within(double reach,
                                                    std::span<const MovingBody> bodies,
                                                    std::span<const Placement> placed) {
    const auto placed_body = [&](std::size_t number) -> Placed {
        return {static_cast<int>(number), bodies[number], placed[number].state, reach};
    };
    near_features_.resize(bodies.size());
    std::vector<BodyContact> found;
    NearPairs& near = reach > 0 ? wide_pairs_ : near_pairs_;
    const std::vector<NearPairs::Pair>& pairs = near.find(bodies, placed);
    auto pair = pairs.begin();
    const auto find_pairs_below = [&](std::size_t number) {
        for (; pair != pairs.end() && pair->first < number; ++pair) {
            if (!bodies[pair->first].is_kinematic() || !bodies[pair->second].is_kinematic()) {
                find_between(placed_body(pair->first), placed_body(pair->second), found);
            }
        }
    };
    for (const std::uint32_t i : near.in_solver()) {
        find_pairs_below(i);
        if (bodies[i].is_ball()) {
            find_for_ball(placed_body(i), found);
        } else if (!bodies[i].is_kinematic()) {
            find_for_solid(placed_body(i), found);
        }
    }
    find_pairs_below(bodies.size());
    return found;
}

SurfaceInfo ContactFinder::info(const ContactPartner& partner) const {
    if (const auto* surface = std::get_if<StaticSurface>(&partner)) {
        return environment_.surfaces[surface->index];
    }
    if (const auto* sphere = std::get_if<StaticSphere>(&partner)) {
        return environment_.spheres[sphere->index].info;
    }
    return std::get<SupportPlane>(partner) == SupportPlane::floor
               ? SurfaceInfo{"floor", MaterialId::floor}
               : SurfaceInfo{"cloth", MaterialId::cloth};
}

std::string ContactFinder::name_of(const ContactPartner& partner,
                                   std::span<const MovingBody> bodies) const {
    const auto* other = std::get_if<OtherBody>(&partner);
    return other != nullptr ? bodies[static_cast<std::size_t>(other->index)].name()
                            : info(partner).name;
}

ContactFinder::Rolling ContactFinder::rolling_of(const Placed& placed, const Vec3& normal) {
    Rolling rolling{placed.body.rolling_length, placed.body.is_ball(), {0, 0, 0}};
    if (rolling.is_ball || rolling.length == 0) {
        return rolling;
    }
    const Vec3 axis = across(to_world(placed.state.orientation, Vec3(0, 0, 1)), normal);
    const double slope = length(axis);
    return slope > kMinEndSlope ? Rolling{rolling.length, false, axis / slope} : Rolling{};
}

void ContactFinder::add(const Placed& placed, const ContactPartner& partner,
                        MaterialId partner_material, const Contact& contact, const Rolling& rolling,
                        std::vector<BodyContact>& found) const {
    const ContactCoefficients& law =
        environment_.contacts.between(placed.body.material, partner_material);
    const auto* other = std::get_if<OtherBody>(&partner);
    const double rolling_arm = rolling.is_ball ? law.rolling : law.solid_rolling;
    const double torsional_arm = rolling.is_ball ? law.torsional : law.solid_rolling;
    found.push_back({{contact, placed.number, other != nullptr ? other->index : -1, law.restitution,
                      law.friction, rolling_arm * rolling.length, torsional_arm * rolling.length,
                      rolling.length, rolling.axis, Vec3(0, 0, 0)},
                     partner});
}

void ContactFinder::add(const Placed& placed, const ContactPartner& partner,
                        MaterialId partner_material, const Contact& contact,
                        std::vector<BodyContact>& found) const {
    add(placed, partner, partner_material, contact, rolling_of(placed, contact.normal), found);
}

/// Of two round bodies, the smaller one counts.
void ContactFinder::add(const Placed& first, const Placed& second, const Contact& contact,
                        std::vector<BodyContact>& found) const {
    Rolling rolling = rolling_of(first, contact.normal);
    const Rolling other = rolling_of(second, contact.normal);
    if (rolling.length == 0 || (other.length > 0 && other.length < rolling.length)) {
        rolling = other;
    }
    add(first, OtherBody{second.number}, second.body.material, contact, rolling, found);
}

void ContactFinder::find_for_ball(const Placed& ball, std::vector<BodyContact>& found) {
    const Vec3& centre = ball.state.position;
    const double radius = ball.body.radius;
    if (environment_.has_cloth && centre.z > -radius) {
        const int pocket = environment_.pocket_below(centre);
        Contact contact;
        contact.depth = -1;
        if (pocket >= 0) {
            contact = environment_.collided->pocket_edges[static_cast<std::size_t>(pocket)].contact(
                centre, radius);
        } else if (environment_.is_over_cloth(centre)) {
            contact = {Vec3(centre.x, centre.y, 0), Vec3(0, 0, 1), radius - centre.z};
        }
        if (contact.depth > -ball.margin()) {
            add(ball, SupportPlane::cloth, MaterialId::cloth, contact, found);
        }
    }
    if (environment_.floor_height) {
        const double height = centre.z - *environment_.floor_height;
        if (radius - height > -ball.margin()) {
            add(ball, SupportPlane::floor, MaterialId::floor,
                {Vec3(centre.x, centre.y, *environment_.floor_height), Vec3(0, 0, 1),
                 radius - height},
                found);
        }
    }
    const std::array meshes{&environment_.collided->mesh, &environment_.scenery_mesh};
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        for (const SurfaceContact& contact :
             meshes[i]->contacts(centre, radius, kBallMargin,
                                 near_features_[static_cast<std::size_t>(ball.number)][i])) {
            add(ball, StaticSurface{contact.surface},
                environment_.surfaces[contact.surface].material, contact, found);
        }
    }
    for (const FixedSolid& solid : environment_.solids) {
        if (solid.has_mesh) {
            continue;
        }
        const Contact contact = convex_contact(*solid.shape, solid.pose, centre, radius);
        if (contact.depth > -ball.margin()) {
            add(ball, StaticSurface{solid.surface}, solid.info.material, contact, found);
        }
    }
    for (std::size_t i = 0; i < environment_.spheres.size(); ++i) {
        const FixedSphere& sphere = environment_.spheres[i];
        const Vec3 d = centre - sphere.centre;
        const double distance = std::sqrt(d.dot(d));
        const double depth = radius + sphere.radius - distance;
        if (depth > -ball.margin() && distance > 1e-9) {
            add(ball, StaticSphere{static_cast<std::uint32_t>(i)}, sphere.info.material,
                {sphere.centre + d * (sphere.radius / distance), d / distance, depth}, found);
        }
    }
}

void ContactFinder::find_for_solid(const Placed& solid, std::vector<BodyContact>& found) const {
    find_on_ground(solid, found);
    Aabb bounds = bounds_of(solid.shape());
    bounds.grow(solid.margin());
    for (const FixedSolid& fixed : environment_.solids) {
        if (!bounds.overlaps(fixed.bounds)) {
            continue;
        }
        for (const Contact& contact :
             solid_contacts(solid.shape(), {fixed.shape.get(), fixed.pose}, solid.margin())) {
            add(solid, StaticSurface{fixed.surface}, fixed.info.material, contact, found);
        }
    }
    if (solid.body.is_box()) {
        find_box_meshes(solid, bounds, found);
    } else {
        find_meshes(solid, bounds, found);
    }
    for (std::size_t i = 0; i < environment_.spheres.size(); ++i) {
        const FixedSphere& sphere = environment_.spheres[i];
        Contact contact =
            convex_contact(*solid.body.shape, solid.shape().pose, sphere.centre, sphere.radius);
        contact.normal = -contact.normal;
        if (contact.depth > -std::max(kBallMargin, solid.reach)) {
            add(solid, StaticSphere{static_cast<std::uint32_t>(i)}, sphere.info.material, contact,
                found);
        }
    }
}

void ContactFinder::find_box_meshes(const Placed& box, const Aabb& bounds,
                                    std::vector<BodyContact>& found) const {
    std::vector<Contact> contacts;
    for (const BoxObstacle& obstacle : environment_.box_obstacles) {
        if (!bounds.overlaps(obstacle.bounds)) {
            continue;
        }
        contacts.clear();
        obstacle.surface.collide(box.body.shape->half_size() * 2, box.shape().pose, contacts);
        for (const Contact& contact : contacts) {
            add(box, StaticSurface{obstacle.number}, obstacle.info.material, contact, found);
        }
    }
}

void ContactFinder::find_meshes(const Placed& solid, const Aabb& bounds,
                                std::vector<BodyContact>& found) const {
    for (const StaticMesh* mesh : {&environment_.collided->mesh, &environment_.scenery_mesh}) {
        for (const SurfaceContact& contact :
             mesh_contacts(solid.shape(), *mesh, bounds, kSolidMargin)) {
            // Solids with flat sides are tested as solids, not as meshes.
            const bool is_solid = std::any_of(
                environment_.solids.begin(), environment_.solids.end(),
                [&](const FixedSolid& fixed) {
                    return mesh == &environment_.scenery_mesh && fixed.surface == contact.surface;
                });
            if (!is_solid) {
                add(solid, StaticSurface{contact.surface},
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
    std::vector<Contact> on_cloth;
    std::vector<Contact> on_floor;
    for (const Vec3& point : points) {
        const Vec3 corner = solid.state.position + to_world(turn, point);
        if (environment_.has_cloth && corner.z < solid.margin() &&
            corner.z > -solid.body.bounding_radius() && environment_.is_over_cloth(corner)) {
            on_cloth.push_back({corner, up, -corner.z});
        }
        if (environment_.floor_height && corner.z - *environment_.floor_height < solid.margin()) {
            on_floor.push_back({corner, up, *environment_.floor_height - corner.z});
        }
    }
    reduce_contacts(on_cloth);
    reduce_contacts(on_floor);
    for (const Contact& contact : on_cloth) {
        add(solid, SupportPlane::cloth, MaterialId::cloth, contact, found);
    }
    for (const Contact& contact : on_floor) {
        add(solid, SupportPlane::floor, MaterialId::floor, contact, found);
    }
}

/// ODE finds the contacts of two boxes, convex_contacts() those of all other pairs.
std::vector<Contact> ContactFinder::solid_contacts(const PlacedShape& a, const PlacedShape& b,
                                                   double margin) {
    std::vector<Contact> contacts;
    if (a.shape->is_box() && b.shape->is_box()) {
        ode::collide_boxes(a.shape->half_size() * 2, a.pose, b.shape->half_size() * 2, b.pose,
                           margin, contacts);
    } else {
        convex_contacts(a, b, margin, contacts);
    }
    return contacts;
}

void ContactFinder::find_between(const Placed& first, const Placed& second,
                                 std::vector<BodyContact>& found) const {
    const Vec3 d = first.state.position - second.state.position;
    const double least_distance =
        first.body.bounding_radius() + second.body.bounding_radius() + second.margin();
    if (d.dot(d) > least_distance * least_distance) {
        return;
    }
    if (first.body.is_ball() && second.body.is_ball()) {
        const double distance = std::sqrt(d.dot(d));
        const double depth = first.body.radius + second.body.radius - distance;
        if (depth > -first.margin() && distance > 1e-9) {
            add(first, second,
                {second.state.position + d * (second.body.radius / distance), d / distance, depth},
                found);
            if (const PairContact* named = named_law(environment_, first.body, second.body)) {
                found.back().contact.restitution = named->restitution;
                found.back().contact.friction = named->friction;
            }
        }
    } else if (first.body.is_ball()) {
        const Contact contact = convex_contact(*second.body.shape, second.shape().pose,
                                               first.state.position, first.body.radius);
        if (contact.depth > -first.margin()) {
            add(first, second, contact, found);
        }
    } else {
        for (const Contact& contact :
             solid_contacts(first.shape(), second.shape(), first.margin())) {
            add(first, second, contact, found);
        }
    }
}

}  // namespace carom::sim
