#include "sim/scheduler/moving_body.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/length.h"
#include "sim/numeric/tolerances.h"
#include "sim/path_detectors.h"

namespace carom::sim {
namespace {

SurfaceCoefficients ground_law(const PairContact& pair) {
    return {{pair.friction, pair.rolling_friction.value_or(0), 0}, pair.restitution, pair.friction};
}

SurfaceCoefficients cloth_law(const std::string& material, const ContactLaw& law) {
    if (material != "ball") {
        return ground_law(law.between(material, "cloth"));
    }
    const BallCloth& cloth = law.ball_cloth;
    return {{cloth.sliding_friction, cloth.rolling_friction, cloth.spinning_friction},
            cloth.restitution,
            cloth.sliding_friction};
}

MovingBody make_body(const Body& from, const StaticEnvironment& environment, std::size_t track) {
    MovingBody body;
    body.description = &from;
    body.material = environment.contacts.id_of(from.material);
    body.track = track;
    body.state = {from.pose.position, from.pose.orientation, from.velocity, from.angular_velocity};
    return body;
}

MovingBody make_ball(const Body& from, double radius, const StaticEnvironment& environment,
                     std::size_t track) {
    MovingBody ball = make_body(from, environment, track);
    static_cast<RigidBody&>(ball) = RigidBody::ball(from.mass, radius, ball.state);
    ball.cloth_law = cloth_law(from.material, environment.law);
    ball.floor_law = ground_law(environment.law.between(from.material, "floor"));
    for (SurfaceCoefficients* law : {&ball.cloth_law, &ball.floor_law}) {
        law->lets_balls_go = rolls_off(environment.downward_gravity, law->motion, environment.pull);
    }
    ball.rolling_length = 1.4 * radius;
    ball.segment.state = ball.state;
    ball.rested_at = from.pose;
    return ball;
}

/// The solid of a kinematic ball, which is treated like any other kinematic solid.
SolidShape round_solid(const Sphere& sphere) {
    return {std::make_shared<const ConvexShape>(ConvexShape::capsule(sphere.radius, 0)), Quat(),
            Vec3(1, 1, 1)};
}

MovingBody make_solid(const Body& from, const SolidShape& solid,
                      const StaticEnvironment& environment, std::size_t track) {
    MovingBody body = make_body(from, environment, track);
    body.shape = solid.shape;
    body.principal = solid.principal;
    if (from.kind == BodyKind::kinematic) {
        body.path.emplace(*from.path, solid.principal);
        body.state = body.path->at(0);
        body.mode = Mode::asleep;
    } else {
        body.mass = from.mass;
        body.inertia = solid.inertia * from.mass;
        if (const double radius = solid.shape->radius(); radius > 0) {
            body.rolling_length = radius + body.inertia.z / (from.mass * radius);
        }
        body.state.orientation = from.pose.orientation * solid.principal;
        body.rested_at = {body.state.position, body.state.orientation};
        body.mode = Mode::solver;
    }
    return body;
}

/// Equal boxes one after the other share their shape: it is read in every step.
void share_shape(std::vector<MovingBody>& solids) {
    if (solids.size() < 2) {
        return;
    }
    MovingBody& last = solids.back();
    const MovingBody& previous = solids[solids.size() - 2];
    if (last.is_box() && previous.is_box() &&
        last.shape->half_size() == previous.shape->half_size()) {
        last.shape = previous.shape;
    }
}

/// Free fall straight down to `height`, where the ball rests.
MotionSegment sinking_segment(double time, const MotionState& state, double height,
                              double gravity) {
    constexpr double kThreshold = 1e-9;  // m
    const double fall = state.position.z - height;
    MotionState sinking{state.position, state.orientation, {0, 0, 0}, {0, 0, 0}};
    if (fall < kThreshold) {
        MotionSegment still;
        still.kind = MotionKind::resting;
        still.start = time;
        still.state = sinking;
        return still;
    }
    const double speed = std::max(-state.velocity.z, 0.0);
    sinking.velocity.z = -speed;
    MotionSegment segment = flight_segment(time, sinking, {0, 0, -gravity});
    segment.end = time + 2 * fall / (speed + std::sqrt(speed * speed + 2 * gravity * fall));
    return segment;
}

}  // namespace

bool MovingBody::has_moved_since_rest() const {
    if (is_still() || !is_in_solver() || is_kinematic()) {
        return !is_still();
    }
    return is_ball() ? is_visible(length(segment.state.position - rested_at.position), 0,
                                  length(segment.state.angular_velocity))
                     : is_visible(distance_from(rested_at), 0, 0);
}

double MovingBody::distance_from(const Pose& pose) const {
    const Quat turn = state.orientation * pose.orientation.inverse();
    return length(state.position - pose.position) + 2 * bounding_radius() * length(turn.v);
}

MotionState MovingBody::with_own_axes(const MotionState& internal) const {
    MotionState result = internal;
    if (principal != Quat()) {
        result.orientation = internal.orientation * Quat(principal.r, -principal.v);
    }
    return result;
}

double MovingBody::max_point_speed() const {
    return length(state.velocity) + bounding_radius() * length(state.angular_velocity);
}

void MovingBody::add_energy(double time, const Vec3& gravity, EnergySample& sample) const {
    if (is_ball()) {
        const Vec3 v = segment.velocity_at(time);
        const Vec3 w = segment.angular_velocity_at(time);
        sample.kinetic += 0.5 * mass * (v.dot(v) + 0.4 * radius * radius * w.dot(w));
        sample.potential -= mass * gravity.dot(segment.position_at(time));
    } else if (!is_kinematic()) {
        sample.kinetic += kinetic_energy();
        sample.potential -= mass * gravity.dot(state.position);
    }
}

double ground_height(SupportPlane ground, const StaticEnvironment& environment) {
    return ground == SupportPlane::floor ? environment.floor_height.value_or(0) : 0;
}

const char* ground_name(SupportPlane ground) {
    return ground == SupportPlane::floor ? "floor" : "cloth";
}

std::vector<MovingBody> make_moving_bodies(const WorldDescription& world,
                                           const StaticEnvironment& environment) {
    std::vector<MovingBody> balls;
    std::vector<MovingBody> solids;
    std::size_t track = 0;
    for (const Body& from : world.bodies) {
        if (from.kind == BodyKind::fixed) {
            continue;
        }
        const auto* sphere = std::get_if<Sphere>(&from.shape);
        const bool is_ball = sphere != nullptr && from.kind == BodyKind::dynamic;
        if (is_ball) {
            balls.push_back(make_ball(from, sphere->radius, environment, track));
        } else if (const auto solid =
                       sphere != nullptr ? round_solid(*sphere) : solid_shape(from.shape)) {
            solids.push_back(make_solid(from, *solid, environment, track));
            share_shape(solids);
        }
        track += from.kind == BodyKind::dynamic ? 1 : 0;
    }
    std::move(solids.begin(), solids.end(), std::back_inserter(balls));
    return balls;
}

MotionSegment next_segment(const MovingBody& ball, double time, const MotionState& state,
                           const StaticEnvironment& environment) {
    if (ball.is_gone()) {
        return sinking_segment(time, state, ball.sinks_to, environment.downward_gravity);
    }
    if (ball.ground == SupportPlane::none) {
        return flight_segment(time, state, environment.gravity);
    }
    MotionSegment segment = cloth_segment(time, state, ball.radius, environment.downward_gravity,
                                          ball.law_of(ball.ground).motion, environment.pull);
    segment.state.position.z = ground_height(ball.ground, environment) + ball.radius;
    return segment;
}

}  // namespace carom::sim
