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

/// Restitution and friction of two balls that collide.
ContactCoefficients pair_law(const StaticEnvironment& environment, const MovingBody& a,
                             const MovingBody& b, double slip_speed) {
    ContactCoefficients law = environment.contacts.between(a.material, b.material);
    if (a.material == MaterialId::ball && b.material == MaterialId::ball) {
        law.friction = ball_friction(environment.law.ball_ball, slip_speed);
    }
    return law;
}

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

}  // namespace

void ImpactResolver::resolve(const PredictedEvent& event) {
    const Vec3 centre = bodies_[event.first].segment.position_at(event.time);
    const Vec2 level(centre.x, centre.y);
    switch (event.kind) {
        case PredictedEventKind::ball:
            return resolve_ball_impact(event);
        case PredictedEventKind::solid:
            return resolve_solid_impact(event);
        case PredictedEventKind::cushion_face:
            return resolve_face_impact(event, level);
        case PredictedEventKind::cushion_corner:
            return resolve_cushion_impact(
                event, nearest_on(environment_.table().corners[event.second], level),
                environment_.law.ball_cushion);
        case PredictedEventKind::pocket_edge:
            return enter_pocket(event);
        case PredictedEventKind::rim:
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
    if (impact.approach > kLeastLoggedSpeed) {
        return recorder_.log_impact(impact.time, impact.a, impact.b, impact.place, impact.normal,
                                    impact.impulse);
    }
    const RigidBody& a = impact.first;
    const RigidBody& b = impact.second;
    const double radius = b.radius > 0 ? std::min(a.radius, b.radius) : a.radius;
    recorder_.contacts().add(
        impact.a, impact.b,
        {impact.time, impact.time, impact.impulse.normal, length(contact_slip(a, b, impact.normal)),
         length(a.state.angular_velocity - b.state.angular_velocity) * radius});
}

void ImpactResolver::resolve_ball_impact(const PredictedEvent& event) {
    MovingBody& a = bodies_[event.first];
    MovingBody& b = bodies_[event.second];
    RigidBody body_a = a.rigid_at(event.time);
    RigidBody body_b = b.rigid_at(event.time);
    const MotionState before_a = body_a.state;
    const MotionState before_b = body_b.state;
    const Vec3 normal = unit(before_a.position - before_b.position);
    const double approach = -(before_a.velocity - before_b.velocity).dot(normal);
    const Vec3 slip = contact_slip(body_a, body_b, normal);
    const ContactCoefficients law = pair_law(environment_, a, b, std::sqrt(slip.dot(slip)));
    const ImpulsePair impulse = ball_ball_impact(bodies_.impact_solver(), body_a, body_b, normal,
                                                 law.restitution, law.friction);
    // The reference models omit the vertical impulse, which would make balls on the cloth hop.
    if (!environment_.law.hop && a.ground != Ground::none && b.ground != Ground::none) {
        body_a.state.velocity.z = 0;
        body_b.state.velocity.z = 0;
    }
    record({event.time, approach, a.name(), b.name(), before_a.position - normal * a.radius, normal,
            impulse, mean_body(body_a, before_a), mean_body(body_b, before_b)});
    const double separation = (body_a.state.velocity - body_b.state.velocity).dot(normal);
    const bool stays =
        stays_in_contact(a, separation, normal) || stays_in_contact(b, separation, normal);
    const bool first_lies = lies_in_pocket(a);
    const bool second_lies = lies_in_pocket(b);
    bodies_.wake(event.first, event.time);
    bodies_.wake(event.second, event.time);
    bodies_.change_state(event.first, event.time, before_a, body_a.state);
    bodies_.change_state(event.second, event.time, before_b, body_b.state);
    if (stays || first_lies) {
        bodies_.enter_solver(event.first, event.time);
    }
    if (stays || second_lies) {
        bodies_.enter_solver(event.second, event.time);
    }
}

void ImpactResolver::resolve_solid_impact(const PredictedEvent& event) {
    const MovingBody& ball = bodies_[event.first];
    const MovingBody& solid = bodies_[event.second];
    RigidBody body = ball.rigid_at(event.time);
    const MotionState before = body.state;
    const MotionState solid_before = solid.state;
    const Pose solid_pose{solid.state.position, solid.state.orientation};
    const Contact contact = convex_contact(*solid.shape, solid_pose, before.position, ball.radius);
    const auto separation = [&](const Vec3& ball_velocity, const MotionState& solid_state) {
        const Vec3 arm = contact.point - solid_pose.position;
        return (ball_velocity - solid_state.velocity - solid_state.angular_velocity.cross(arm))
            .dot(contact.normal);
    };
    const double approach = -separation(before.velocity, solid_before);
    if (approach <= 0) {
        return bodies_.enter_solver(event.first, event.time);
    }
    const ContactCoefficients& law = environment_.contacts.between(ball.material, solid.material);
    RigidBody unturned = body;
    unturned.state.orientation = Quat();
    ode::ImpactResult result;
    MotionState solid_after = solid_before;
    if (solid.is_kinematic()) {
        result = bodies_.impact_solver().solve_kinematic(unturned,
                                                         velocity_at(solid_before, contact.point),
                                                         contact, law.restitution, law.friction);
    } else {
        result =
            bodies_.impact_solver().solve(unturned, solid, contact, law.restitution, law.friction);
        solid_after.velocity = result.second.linear;
        solid_after.angular_velocity = result.second.angular;
    }
    body.set(result.first);
    record({event.time, approach, ball.name(), solid.name(), contact.point, contact.normal,
            result.impulse, mean_body(body, before),
            surface_moving_at(velocity_at(solid_before, contact.point))});
    const bool stays = separation(body.state.velocity, solid_after) < kLandingSpeed;
    bodies_.change_velocities(event.second, event.time, solid_before, solid_after);
    bodies_.change_state(event.first, event.time, before, body.state);
    if (stays) {
        bodies_.enter_solver(event.first, event.time);
    }
}

void ImpactResolver::resolve_surface_impact(const PredictedEvent& event) {
    const MovingBody& ball = bodies_[event.first];
    const Vec3 centre = ball.segment.position_at(event.time);
    if (event.kind == PredictedEventKind::rim) {
        bounce(event, environment_.collided->rims[event.second].contact(centre, ball.radius),
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

void ImpactResolver::bounce(const PredictedEvent& event, const Contact& contact,
                            const SurfaceInfo& info) {
    const MovingBody& ball = bodies_[event.first];
    RigidBody body = ball.rigid_at(event.time);
    const MotionState before = body.state;
    const double approach = -before.velocity.dot(contact.normal);
    const ContactCoefficients& law = environment_.contacts.between(ball.material, info.material);
    const ImpulsePair impulse =
        is_lining(info.material, contact.normal)
            ? lining_impact(body, contact.normal, law.restitution, law.friction)
            : ball_static_impact(bodies_.impact_solver(), body, contact.normal, law.restitution,
                                 law.friction);
    if (!environment_.law.hop && ball.ground != Ground::none && std::abs(contact.normal.z) < 1e-6) {
        body.state.velocity.z = 0;
    }
    record({event.time, approach, ball.name(), info.name, contact.point, contact.normal, impulse,
            mean_body(body, before), surface_moving_at({0, 0, 0})});
    const bool stays =
        stays_in_contact(ball, body.state.velocity.dot(contact.normal), contact.normal);
    bodies_.change_state(event.first, event.time, before, body.state);
    if (stays) {
        bodies_.enter_solver(event.first, event.time);
    }
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
    if (separation < kLeastSeparation) {
        body.state.velocity += inward * (kLeastSeparation - separation);
        if (approach <= kLeastLoggedSpeed) {
            impulse.normal += body.mass * (kLeastSeparation - separation);
        }
    }
    record({event.time, approach, ball.name(), kCushion, nose, normal, impulse,
            mean_body(body, before), surface_moving_at({0, 0, 0})});
    const bool stays = stays_in_contact(ball, body.state.velocity.dot(inward), inward);
    bodies_.change_state(event.first, event.time, before, body.state);
    if (stays) {
        bodies_.enter_solver(event.first, event.time);
    }
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
    const auto ground = static_cast<Ground>(event.second);
    const MotionState before = ball.segment.state_at(event.time);
    if (environment_.downward_gravity <= 0) {
        const Vec3 up(0, 0, 1);
        bounce(
            event, {before.position - up * ball.radius, up, 0},
            {ground_name(ground), ground == Ground::floor ? MaterialId::floor : MaterialId::cloth});
        return;
    }
    ball.ground = ground;
    bodies_.change_state(event.first, event.time, before, before);
}

}  // namespace carom::sim
