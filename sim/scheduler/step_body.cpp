#include "sim/scheduler/step_body.h"

#include "core/length.h"

namespace carom::sim {
namespace {

StepBody ball_body(const Ball& ball) {
    StepBody body;
    body.name = &ball.name;
    body.material = ball.material;
    body.track = ball.track;
    body.is_ball = true;
    body.radius = ball.radius;
    body.mass = ball.mass;
    body.inertia = Vec3(0.4 * ball.mass * ball.radius * ball.radius);
    return body;
}

/// The solid of a kinematic ball, which is treated like any other kinematic solid.
SolidShape round_solid(const Sphere& sphere) {
    return {std::make_shared<const ConvexShape>(ConvexShape::capsule(sphere.radius, 0)), Quat(),
            Vec3(1, 1, 1)};
}

StepSolid kinematic_solid(const Body& from) {
    const auto* sphere = std::get_if<Sphere>(&from.shape);
    const SolidShape solid = sphere != nullptr ? round_solid(*sphere) : *solid_shape(from.shape);
    return {&from, 0, solid, KinematicPath(*from.path, solid.principal)};
}

StepBody solid_body(const StepSolid& solid, const ContactTable& contacts) {
    const Body& from = *solid.body;
    StepBody body;
    body.name = &from.name;
    body.material = contacts.id_of(from.material);
    body.track = solid.track;
    body.shape = solid.solid.shape.get();
    body.principal = solid.solid.principal;
    body.is_in_ode = true;
    if (solid.path) {
        body.path = &*solid.path;
        body.state = body.path->at(0);
        return body;
    }
    body.mass = from.mass;
    body.inertia = solid.solid.inertia * from.mass;
    body.state = {from.pose.position, from.pose.orientation * body.principal, from.velocity,
                  from.angular_velocity};
    body.is_awake = true;
    body.rested_at = {body.state.position, body.state.orientation};
    return body;
}

}  // namespace

double StepBody::bounding_radius() const {
    return is_ball ? radius : shape->bounding_radius();
}

MotionState StepBody::with_own_axes(const MotionState& internal) const {
    MotionState result = internal;
    if (principal != Quat()) {
        result.orientation = internal.orientation * Quat(principal.r, -principal.v);
    }
    return result;
}

Aabb StepBody::bounds() const {
    if (is_ball) {
        return {state.position - Vec3(radius), state.position + Vec3(radius)};
    }
    return bounds_of(placed());
}

double StepBody::max_point_speed() const {
    return length(state.velocity) + bounding_radius() * length(state.angular_velocity);
}

bool StepBody::has_moved_since_rest() const {
    if (!is_awake || is_kinematic()) {
        return is_awake;
    }
    const Quat turn = state.orientation * rested_at.orientation.inverse();
    const double moved = length(state.position - rested_at.position);
    return moved + 2 * bounding_radius() * length(turn.v) > kLeastDisplacement;
}

Vec3 StepBody::velocity_at(const Vec3& point) const {
    return state.velocity + state.angular_velocity.cross(point - state.position);
}

double StepBody::kinetic_energy_in(const MotionState& frame) const {
    StepBody relative = *this;
    relative.state.velocity -=
        frame.velocity + frame.angular_velocity.cross(state.position - frame.position);
    relative.state.angular_velocity -= frame.angular_velocity;
    return relative.kinetic_energy();
}

double StepBody::kinetic_energy() const {
    const Vec3 w = to_body(state.orientation, state.angular_velocity);
    return 0.5 * mass * state.velocity.dot(state.velocity) +
           0.5 * (inertia.x * w.x * w.x + inertia.y * w.y * w.y + inertia.z * w.z * w.z);
}

ode::ImpactBody StepBody::impact_body() const {
    return {mass,
            inertia,
            {state.position, state.orientation},
            {state.velocity, state.angular_velocity}};
}

std::vector<StepSolid> make_step_solids(const WorldDescription& world) {
    std::vector<StepSolid> solids;
    std::size_t track = 0;
    for (const Body& body : world.bodies) {
        if (body.kind == BodyKind::kinematic) {
            solids.push_back(kinematic_solid(body));
        }
        if (body.kind != BodyKind::dynamic) {
            continue;
        }
        if (const auto solid = solid_shape(body.shape)) {
            solids.push_back({&body, track, *solid, {}});
        }
        ++track;
    }
    return solids;
}

std::vector<StepBody> make_step_bodies(const std::vector<Ball>& balls,
                                       const std::vector<StepSolid>& solids,
                                       const ContactTable& contacts) {
    std::vector<StepBody> bodies;
    bodies.reserve(balls.size() + solids.size());
    for (const Ball& ball : balls) {
        bodies.push_back(ball_body(ball));
    }
    for (const StepSolid& solid : solids) {
        bodies.push_back(solid_body(solid, contacts));
    }
    return bodies;
}

}  // namespace carom::sim
