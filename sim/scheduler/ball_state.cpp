#include "sim/scheduler/ball_state.h"

#include <cmath>

namespace carom::sim {
namespace {

/// A ball that ODE carries turns on the spot if its surface is faster than this (m/s).
constexpr double kLeastTurning = 0.01;

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

Ball make_ball(const Body& body, double radius, const Surroundings& around) {
    Ball ball;
    ball.name = body.name;
    ball.material = around.contacts.id_of(body.material);
    ball.mass = body.mass;
    ball.radius = radius;
    ball.cloth_law = cloth_law(body.material, around.law);
    ball.floor_law = ground_law(around.law.between(body.material, "floor"));
    ball.stretch.state = {body.pose.position, body.pose.orientation, body.velocity,
                          body.angular_velocity};
    ball.rested_at = body.pose.position;
    return ball;
}

}  // namespace

bool Ball::has_left() const {
    if (!is_stepped()) {
        return !is_still();
    }
    const Vec3 way = stretch.state.position - rested_at;
    const Vec3& spin = stretch.state.angular_velocity;
    return way.dot(way) > kLeastMove * kLeastMove ||
           spin.dot(spin) * radius * radius > kLeastTurning * kLeastTurning;
}

double ground_height(Ground ground, const Surroundings& around) {
    return ground == Ground::floor ? around.floor_height.value_or(0) : 0;
}

const char* ground_name(Ground ground) {
    return ground == Ground::floor ? "floor" : "cloth";
}

std::vector<Ball> make_balls(const WorldDescription& world, const Surroundings& around) {
    std::vector<Ball> balls;
    std::size_t track = 0;
    for (const Body& body : world.bodies) {
        if (body.kind != BodyKind::dynamic) {
            continue;
        }
        if (const auto* sphere = std::get_if<Sphere>(&body.shape)) {
            balls.push_back(make_ball(body, sphere->radius, around));
            balls.back().track = track;
        }
        ++track;
    }
    return balls;
}

Stretch next_stretch(const Ball& ball, double time, const MotionState& state,
                     const Surroundings& around) {
    if (ball.ground == Ground::none) {
        return flight_stretch(time, state, around.gravity);
    }
    Stretch stretch = cloth_stretch(time, state, ball.radius, around.downward_gravity,
                                    ball.law_of(ball.ground).motion);
    stretch.state.position.z = ground_height(ball.ground, around) + ball.radius;
    return stretch;
}

}  // namespace carom::sim
