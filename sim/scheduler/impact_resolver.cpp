#include "sim/scheduler/impact_resolver.h"

#include <algorithm>
#include <cmath>

#include "core/length.h"
#include "core/rigid.h"
#include "sim/impact/cushion_impact.h"
#include "sim/scheduler/contact_table.h"
#include "sim/scheduler/event_predictor.h"

namespace carom::sim {
namespace {

const std::string kCushion = "cushion";

/// The foot of the perpendicular from `point` to the nose line of a face.
Vec2 nearest_on(const billiards::CushionFace& face, const Vec2& point) {
    return point - face.normal * (point - face.from).dot(face.normal);
}

Vec2 nearest_on(const billiards::CushionCorner& corner, const Vec2& point) {
    const Vec2 d = point - corner.centre;
    return corner.centre + d * (corner.radius / std::sqrt(d.dot(d)));
}

/// A ball with the means of its velocities before and after an impact.
RigidBody mean_body(const RigidBody& after, const MotionState& before) {
    RigidBody mean = after;
    mean.state.velocity = (before.velocity + after.state.velocity) * 0.5;
    mean.state.angular_velocity = (before.angular_velocity + after.state.angular_velocity) * 0.5;
    return mean;
}

/// What a ball hits, as a body without a radius: only the velocity of its surface counts.
RigidBody surface_moving_at(const Vec3& velocity) {
    RigidBody body;
    body.state.velocity = velocity;
    return body;
}

/// A ball in a pocket that touches more than the ball which strikes it. In closed form it could
/// sink through the floor: a ball that overlaps a surface by rounding and separates from it more
/// slowly than it falls never comes apart from it.
bool lies_in_pocket(const MovingBody& ball) {
    return (ball.is_in_solver() || ball.is_asleep()) && ball.segment.state.position.z < 0;
}

/// The contacts that closed, in the order of time in which they did.
std::vector<std::size_t> in_order_of_touch(const std::vector<GroupContactResult>& results) {
    std::vector<std::size_t> touched;
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (results[i].touched_after) {
            touched.push_back(i);
        }
    }
    std::stable_sort(touched.begin(), touched.end(), [&](std::size_t i, std::size_t k) {
        return *results[i].touched_after < *results[k].touched_after;
    });
    return touched;
}

}  // namespace

void ImpactResolver::resolve(const PredictedEvent& event) {
    const Vec3 centre = bodies_[event.first].segment.position_at(event.time);
    const Vec2 level(centre.x, centre.y);
    switch (event.kind) {
        case PredictedEventKind::ball:
            return resolve_ball_impact(event);
        case PredictedEventKind::solid:
            return bodies_.enter_solver(event.first, event.time);  // RestitutionPass resolves it
        case PredictedEventKind::cushion_face:
            return resolve_face_impact(event, level);
        case PredictedEventKind::cushion_corner:
            return resolve_cushion_impact(
                event, nearest_on(environment_.table().corners[event.second], level),
                environment_.law.ball_cushion);
        case PredictedEventKind::pocket_edge:
            return enter_pocket(event);
        case PredictedEventKind::pocket_edge_hit:
        case PredictedEventKind::table_feature:
        case PredictedEventKind::scenery_feature:
        case PredictedEventKind::fixed_sphere:
        case PredictedEventKind::fixed_solid:
            return resolve_surface_impact(event);
        case PredictedEventKind::ground:
            return land(event);
        case PredictedEventKind::slate_underside:
            return resolve_slate_impact(event);
        case PredictedEventKind::below_cloth:
            return cross_below_cloth(event);
        case PredictedEventKind::segment_end:
            return bodies_.begin_next_segment(event.first, event.time);
        case PredictedEventKind::path:
        case PredictedEventKind::cell_crossing:
        case PredictedEventKind::search_again:  // handled by the scheduler
            break;
    }
}

/// Fast impacts are events. Slow ones that follow each other are a lasting contact.
void ImpactResolver::record(const Impact& impact) {
    if (impact.approach > kMinLoggedSpeed) {
        return recorder_.log_impact(impact.time, impact.a, impact.b, impact.place, impact.normal,
                                    impact.impulse);
    }
    const RigidBody& a = impact.first;
    const RigidBody& b = impact.second;
    const double radius = b.radius > 0 ? std::min(a.radius, b.radius) : a.radius;
    recorder_.add_contact(
        impact.a, impact.b,
        {impact.time, impact.time, impact.impulse.normal, length(contact_slip(a, b, impact.normal)),
         length(a.state.angular_velocity - b.state.angular_velocity) * radius});
}

ImpactGroup ImpactResolver::group_of(const PredictedEvent& event) const {
    return find_impact_group(bodies_.balls(), event.first, event.second, event.time, predictor_,
                             environment_);
}

bool ImpactResolver::involves_solver(const PredictedEvent& event) const {
    if (!bodies_.is_solver_active()) {
        return false;
    }
    const ImpactGroup group = group_of(event);
    return std::any_of(group.indices.begin(), group.indices.end(),
                       [&](std::uint32_t index) { return bodies_[index].is_in_solver(); });
}

/// True if one of the balls touches a solid or a fixed body, or may while the two compress each
/// other: then the solver resolves the impact of all. Cushions and the linings of pockets are much
/// softer than balls, and follow.
bool ImpactResolver::reaches_obstacle(const PredictedEvent& event, const ImpactGroup& group) const {
    const std::span<const MovingBody> balls = bodies_.balls();
    if (bodies_.solids().empty() && !environment_.has_obstacles()) {
        return false;
    }
    const double approach = group.approach();
    if (approach <= kBounceSpeed) {
        return false;
    }
    const RigidBody& a = group.balls[0];
    const RigidBody& b = group.balls[1];
    std::vector<Placement> placed = placements_of(bodies_.all());
    for (std::size_t i = 0; i < placed.size(); ++i) {
        placed[i].mode = i < balls.size() ? Mode::gone : Mode::asleep;
    }
    for (const std::uint32_t index : group.indices) {
        placed[index] = {balls[index].segment.state_at(event.time), Mode::solver};
    }
    const double duration =
        contact_time(ball_stiffness(a.radius * b.radius / (a.radius + b.radius)),
                     a.mass * b.mass / (a.mass + b.mass), approach);
    const std::vector<BodyContact> contacts =
        finder_.find_within(std::min(2 * approach * duration, kMaxReach), bodies_.all(), placed);
    return std::any_of(contacts.begin(), contacts.end(), [&](const BodyContact& found) {
        if (found.is_between_bodies()) {
            return !bodies_.all()[static_cast<std::size_t>(found.contact.second)].is_ball();
        }
        const MaterialId material = finder_.info(found.partner).material;
        return !std::holds_alternative<SupportPlane>(found.partner) &&
               material != MaterialId::cushion && material != MaterialId::pocket;
    });
}

void ImpactResolver::leave_to_solver(const PredictedEvent& event) {
    for (const std::uint32_t index : {event.first, event.second}) {
        bodies_.wake_island(index, event.time);
        if (!bodies_[index].is_in_solver()) {
            bodies_.enter_solver(index, event.time);
        }
    }
}

/// The contacts of the group that close, in the order of time in which they do, and the balls after
/// it.
std::vector<ImpactResolver::Touch> ImpactResolver::hit_group(const ImpactGroup& group,
                                                             std::vector<RigidBody>& after) const {
    std::vector<GroupBody> bodies;
    for (const RigidBody& ball : group.balls) {
        bodies.push_back(group_body(ball));
    }
    const std::vector<GroupContactResult> results =
        group_impact(bodies, group.contacts, environment_.law.ball_ball);
    for (std::size_t i = 0; i < after.size(); ++i) {
        after[i].set({bodies[i].velocity, bodies[i].angular_velocity});
    }
    std::vector<Touch> touches;
    for (const std::size_t i : in_order_of_touch(results)) {
        touches.push_back({group.contacts[i].first, group.contacts[i].second, results[i].approach,
                           results[i].normal, results[i].impulse});
    }
    return touches;
}

/// The same for the two balls that meet, by the law of pairs.
ImpactResolver::Touch ImpactResolver::hit_pair(const ImpactGroup& group,
                                               std::vector<RigidBody>& after) const {
    const MovingBody& a = bodies_[group.indices[0]];
    const MovingBody& b = bodies_[group.indices[1]];
    after = group.balls;
    const Vec3 normal = group.normal();
    const double slip = length(contact_slip(after[0], after[1], normal));
    const ContactCoefficients law = pair_law(environment_, a, b, slip);
    const ImpulsePair impulse = ball_ball_impact(bodies_.impact_solver(), after[0], after[1],
                                                 normal, law.restitution, law.friction);
    // The reference models omit the vertical impulse, which would make balls on the cloth hop.
    if (!environment_.law.hop && a.ground != SupportPlane::none && b.ground != SupportPlane::none) {
        after[0].state.velocity.z = 0;
        after[1].state.velocity.z = 0;
    }
    return {0, 1, group.approach(), normal, impulse};
}

/// The law of pairs is exact for two balls that come apart before they or others touch a third one.
void ImpactResolver::resolve_ball_impact(const PredictedEvent& event) {
    const ImpactGroup group = group_of(event);
    // The path of a ball in the solver closed the gap, which its contacts have changed meanwhile.
    const bool has_parted = group.approach() <= 0 && (bodies_[event.first].is_in_solver() ||
                                                      bodies_[event.second].is_in_solver());
    if (has_parted || reaches_obstacle(event, group)) {
        return leave_to_solver(event);
    }
    std::vector<RigidBody> after = group.balls;
    std::vector<Touch> touches;
    if (!group.contacts.empty()) {
        touches = hit_group(group, after);
    }
    if (touches.size() < 2) {
        touches = {hit_pair(group, after)};
    }
    std::vector<char> is_touched(after.size(), 0);
    std::vector<char> enters_solver(after.size(), 0);
    for (const Touch& touch : touches) {
        const MovingBody& a = bodies_[group.indices[touch.first]];
        const MovingBody& b = bodies_[group.indices[touch.second]];
        const RigidBody& first = group.balls[touch.first];
        const RigidBody& second = group.balls[touch.second];
        const Vec3& normal = touch.normal;
        record({event.time, touch.approach, a.name(), b.name(),
                first.state.position - normal * first.radius, normal, touch.impulse,
                mean_body(after[touch.first], first.state),
                mean_body(after[touch.second], second.state)});
        const double separation =
            (after[touch.first].state.velocity - after[touch.second].state.velocity).dot(normal);
        const bool stays =
            stays_in_contact(a, separation, normal) || stays_in_contact(b, separation, normal);
        for (const std::size_t member : {touch.first, touch.second}) {
            is_touched[member] = 1;
            if (stays || lies_in_pocket(bodies_[group.indices[member]])) {
                enters_solver[member] = 1;
            }
        }
    }
    for (std::size_t i = 0; i < after.size(); ++i) {
        if (is_touched[i] != 0) {
            bodies_.wake_island(group.indices[i], event.time);
        }
    }
    for (std::size_t i = 0; i < after.size(); ++i) {
        if (is_touched[i] != 0) {
            const MotionState before = bodies_[group.indices[i]].segment.state_at(event.time);
            after[i].state.orientation = before.orientation;
            part(group.indices[i], event.time, before, after[i].state, enters_solver[i] != 0);
        }
    }
}

void ImpactResolver::part(std::uint32_t ball, double time, const MotionState& before,
                          const MotionState& after, bool enters_solver) {
    bodies_.change_state(ball, time, before, after);
    if (enters_solver) {
        bodies_.enter_solver(ball, time);
    }
}

void ImpactResolver::resolve_surface_impact(const PredictedEvent& event) {
    const MovingBody& ball = bodies_[event.first];
    const Vec3 centre = ball.segment.position_at(event.time);
    if (event.kind == PredictedEventKind::pocket_edge_hit) {
        bounce(event,
               environment_.collided->pocket_edges[event.second].contact(centre, ball.radius),
               {"cloth", MaterialId::cloth});
    } else if (event.kind == PredictedEventKind::fixed_sphere) {
        const FixedSphere& sphere = environment_.spheres[event.second];
        const Vec3 normal = unit(centre - sphere.centre);
        bounce(event, {sphere.centre + normal * sphere.radius, normal, 0}, sphere.info);
    } else if (event.kind == PredictedEventKind::fixed_solid) {
        const FixedSolid& solid = environment_.solids[event.second];
        bounce(event, convex_contact(*solid.shape, solid.pose, centre, ball.radius), solid.info);
    } else {
        const bool is_table = event.kind == PredictedEventKind::table_feature;
        const StaticMesh& mesh = is_table ? environment_.collided->mesh : environment_.scenery_mesh;
        const SurfaceContact contact = mesh.contact(event.second, centre, ball.radius);
        bounce(event, contact, environment_.surfaces[contact.surface]);
    }
}

/// The slate is taken to be as hard as the rails' wood.
void ImpactResolver::resolve_slate_impact(const PredictedEvent& event) {
    const MovingBody& ball = bodies_[event.first];
    const Vec3 down(0, 0, -1);
    const Vec3 top = ball.segment.position_at(event.time) - down * ball.radius;
    bounce(event, {top, down, 0}, {"rail", MaterialId::rail});
}

/// True if a ball that meets a surface at `approach` (m/s) touches another one, or may meanwhile:
/// then the solver resolves the impact of all.
bool ImpactResolver::reaches_ball(const PredictedEvent& event, double approach) const {
    if (approach <= kBounceSpeed) {
        return false;
    }
    const std::span<const MovingBody> balls = bodies_.balls();
    const MovingBody& ball = balls[event.first];
    const Vec3 centre = ball.segment.position_at(event.time);
    const double reach =
        2 * approach * contact_time(ball_stiffness(ball.radius), ball.mass, approach);
    std::vector<std::uint32_t> near;
    predictor_.find_near(event.first, near);
    return std::any_of(near.begin(), near.end(), [&](std::uint32_t index) {
        const MovingBody& other = balls[index];
        return !other.is_gone() && length(other.segment.position_at(event.time) - centre) <
                                       ball.radius + other.radius + reach;
    });
}

void ImpactResolver::bounce(const PredictedEvent& event, const Contact& contact,
                            const SurfaceInfo& info) {
    const MovingBody& ball = bodies_[event.first];
    RigidBody body = ball.rigid_at(event.time);
    const MotionState before = body.state;
    const double approach = -before.velocity.dot(contact.normal);
    if (reaches_ball(event, approach)) {
        return bodies_.enter_solver(event.first, event.time);
    }
    const ContactCoefficients& law = environment_.contacts.between(ball.material, info.material);
    const ImpulsePair impulse =
        is_lining(info.material, contact.normal)
            ? lining_impact(body, contact.normal, law.restitution, law.friction)
            : ball_static_impact(bodies_.impact_solver(), body, contact.normal, law.restitution,
                                 law.friction);
    if (!environment_.law.hop && ball.ground != SupportPlane::none &&
        std::abs(contact.normal.z) < 1e-6) {
        body.state.velocity.z = 0;
    }
    record({event.time, approach, ball.name(), info.name, contact.point, contact.normal, impulse,
            mean_body(body, before), surface_moving_at({0, 0, 0})});
    part(event.first, event.time, before, body.state,
         stays_in_contact(ball, body.state.velocity.dot(contact.normal), contact.normal));
}

void ImpactResolver::resolve_face_impact(const PredictedEvent& event, const Vec2& centre) {
    const billiards::CushionFace& face = environment_.table().faces[event.second];
    resolve_cushion_impact(event, nearest_on(face, centre),
                           face.is_jaw ? environment_.jaw : environment_.law.ball_cushion);
}

void ImpactResolver::resolve_cushion_impact(const PredictedEvent& event, const Vec2& nearest,
                                            const BallCushion& cushion) {
    const MovingBody& ball = bodies_[event.first];
    RigidBody body = ball.rigid_at(event.time);
    const MotionState before = body.state;
    const Vec3 nose(nearest.x, nearest.y, environment_.nose_height);
    const Vec3 normal = unit(before.position - nose);
    const Vec3 inward = unit(Vec3(normal.x, normal.y, 0));
    const double approach = -before.velocity.dot(inward);
    ImpulsePair impulse;
    if (ball.material == MaterialId::ball) {
        impulse = cushion_impact(body, inward, normal, cushion,
                                 environment_.law.ball_cloth.sliding_friction);
    } else {
        const ContactCoefficients& numbers =
            environment_.contacts.between(ball.material, MaterialId::cushion);
        impulse = ball_static_impact(bodies_.impact_solver(), body, normal, numbers.restitution,
                                     numbers.friction);
    }
    if (!environment_.law.hop) {
        body.state.velocity.z = 0;
    }
    const double separation = body.state.velocity.dot(inward);
    if (separation < kMinSeparation) {
        body.state.velocity += inward * (kMinSeparation - separation);
        if (approach <= kMinLoggedSpeed) {
            impulse.normal += body.mass * (kMinSeparation - separation);
        }
    }
    record({event.time, approach, ball.name(), kCushion, nose, normal, impulse,
            mean_body(body, before), surface_moving_at({0, 0, 0})});
    part(event.first, event.time, before, body.state,
         stays_in_contact(ball, body.state.velocity.dot(inward), inward));
}

/// A ball that passes the edge faster than sqrt(g R) leaves it immediately: the edge would have to
/// pull it down. A slower ball first rolls over the edge.
void ImpactResolver::enter_pocket(const PredictedEvent& event) {
    const MovingBody& ball = bodies_[event.first];
    const Vec3 centre = ball.segment.position_at(event.time);
    const billiards::Pocket& pocket = environment_.table().pockets[event.second];
    const Vec3 inward = unit(Vec3(pocket.centre.x - centre.x, pocket.centre.y - centre.y, 0));
    const double speed = ball.segment.velocity_at(event.time).dot(inward);
    if (speed * speed > environment_.downward_gravity * ball.radius) {
        bodies_.leave_ground(event.first, event.time);
    } else {
        recorder_.add_key(ball.track, event.time, ball.segment.state_at(event.time));
        bodies_.enter_solver(event.first, event.time);
    }
}

void ImpactResolver::cross_below_cloth(const PredictedEvent& event) {
    const MovingBody& ball = bodies_[event.first];
    bodies_.log_below_cloth(event.first, event.time, ball.segment.position_at(event.time));
    bodies_.begin_next_segment(event.first, event.time);
}

void ImpactResolver::land(const PredictedEvent& event) {
    MovingBody& ball = bodies_[event.first];
    const auto ground = static_cast<SupportPlane>(event.second);
    const MotionState before = ball.segment.state_at(event.time);
    if (environment_.downward_gravity <= 0) {
        bounce(event, {before.position - kUp * ball.radius, kUp, 0},
               {ground_name(ground),
                ground == SupportPlane::floor ? MaterialId::floor : MaterialId::cloth});
        return;
    }
    ball.ground = ground;
    bodies_.change_state(event.first, event.time, before, before);
}

}  // namespace carom::sim
