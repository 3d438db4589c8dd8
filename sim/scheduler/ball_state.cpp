#include "sim/scheduler/ball_state.h"

#include <algorithm>
#include <cmath>

namespace carom::sim {
namespace {

/// A ball stepped by ODE counts as spinning in place if its surface is faster than this (m/s).
constexpr double kLeastSurfaceSpeed = 0.01;

GroundLaw ground_law(const PairContact& pair) {
    return {{pair.friction, pair.rolling_friction, 0}, pair.restitution, pair.friction};
}

GroundLaw cloth_law(const std::string& material, const ContactLaw& law) {
    if (material != "ball") {
        return ground_law(law.between(material, "cloth"));
    }
    const BallCloth& cloth = law.ball_cloth;
    return {{cloth.sliding_friction, cloth.rolling_friction, cloth.spinning_friction},
            cloth.restitution,
            cloth.sliding_friction};
}

Ball make_ball(const Body& body, double radius, const StaticEnvironment& environment) {
    Ball ball;
    ball.name = body.name;
    ball.material = environment.contacts.id_of(body.material);
    ball.mass = body.mass;
    ball.radius = radius;
    ball.cloth_law = cloth_law(body.material, environment.law);
    ball.floor_law = ground_law(environment.law.between(body.material, "floor"));
    ball.segment.state = {body.pose.position, body.pose.orientation, body.velocity,
                          body.angular_velocity};
    ball.rested_at = body.pose.position;
    return ball;
}

/// Free fall straight down to `height`, where the ball rests.
MotionSegment sinking_segment(double time, const MotionState& state, double height,
                              double gravity) {
    constexpr double kClose = 1e-9;  // m
    const double fall = state.position.z - height;
    MotionState sinking{state.position, state.orientation, {0, 0, 0}, {0, 0, 0}};
    if (fall < kClose) {
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

bool Ball::has_moved_since_rest() const {
    if (!is_stepped()) {
        return !is_still();
    }
    const Vec3 displacement = segment.state.position - rested_at;
    const Vec3& spin = segment.state.angular_velocity;
    return displacement.dot(displacement) > kLeastDisplacement * kLeastDisplacement ||
           spin.dot(spin) * radius * radius > kLeastSurfaceSpeed * kLeastSurfaceSpeed;
}

double ground_height(Ground ground, const StaticEnvironment& environment) {
    return ground == Ground::floor ? environment.floor_height.value_or(0) : 0;
}

const char* ground_name(Ground ground) {
    return ground == Ground::floor ? "floor" : "cloth";
}

std::vector<Ball> make_balls(const WorldDescription& world, const StaticEnvironment& environment) {
    std::vector<Ball> balls;
    std::size_t track = 0;
    for (const Body& body : world.bodies) {
        if (body.kind != BodyKind::dynamic) {
            continue;
        }
        if (const auto* sphere = std::get_if<Sphere>(&body.shape)) {
            balls.push_back(make_ball(body, sphere->radius, environment));
            balls.back().track = track;
        }
        ++track;
    }
    return balls;
}

MotionSegment next_segment(const Ball& ball, double time, const MotionState& state,
                           const StaticEnvironment& environment) {
    if (ball.sinks_to) {
        return sinking_segment(time, state, *ball.sinks_to, environment.downward_gravity);
    }
    if (ball.ground == Ground::none) {
        return flight_segment(time, state, environment.gravity);
    }
    MotionSegment segment = cloth_segment(time, state, ball.radius, environment.downward_gravity,
                                          ball.law_of(ball.ground).motion);
    segment.state.position.z = ground_height(ball.ground, environment) + ball.radius;
    return segment;
}

}  // namespace carom::sim
