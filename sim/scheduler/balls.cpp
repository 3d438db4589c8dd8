#include "sim/scheduler/balls.h"

#include <algorithm>
#include <cmath>

namespace carom::sim {
namespace {

const Vec3 kUp(0, 0, 1);

const char* ground_name(Ground ground) {
    switch (ground) {
        case Ground::cloth:
            return "cloth";
        case Ground::floor:
            return "floor";
        case Ground::pocket_floor:
            return "pocket";
        case Ground::none:
            break;
    }
    return "";
}

EventKind event_of(MotionKind kind) {
    switch (kind) {
        case MotionKind::sliding:
            return EventKind::sliding;
        case MotionKind::rolling:
            return EventKind::rolling;
        case MotionKind::spinning:
            return EventKind::spinning;
        case MotionKind::resting:
            return EventKind::resting;
        case MotionKind::flying:
        case MotionKind::stepped:
            break;
    }
    return EventKind::airborne;
}

/// Which level surface a ball placed at `state` stands on.
Ground ground_at_start(const Ball& ball, const Surroundings& around) {
    constexpr double kClose = 1e-6;  // m
    const MotionState& state = ball.stretch.state;
    if (around.downward_gravity <= 0 || state.velocity.z > kLandingSpeed)
        return Ground::none;
    const double bottom = state.position.z - ball.radius;
    if (std::abs(bottom) < kClose && around.is_over_cloth(state.position))
        return Ground::cloth;
    if (around.floor_height && std::abs(bottom - *around.floor_height) < kClose)
        return Ground::floor;
    return Ground::none;
}

}  // namespace

Balls::Balls(const WorldDescription& world, const Surroundings& around, Recording& recording)
    : around_(around), recording_(recording), balls_(make_balls(world, around)) {}

void Balls::start(double time) {
    for (Ball& ball : balls_) {
        ball.ground = ground_at_start(ball, around_);
        if (ball.ground == Ground::none)
            ball.pocket = around_.pocket_below(ball.stretch.state.position);
        ball.stretch = next_stretch(ball, time, ball.stretch.state, around_);
        recording_.keep(ball.track, time, ball.stretch.state);
    }
}

void Balls::change(std::uint32_t index, double time, const MotionState& before, MotionState after) {
    Ball& ball = balls_[index];
    settle(ball, time, after);
    begin(ball, time, after);
    recording_.add_break(ball.track, time, before, ball.stretch.state);
}

void Balls::settle(Ball& ball, double time, MotionState& state) {
    if (ball.ground == Ground::none)
        return;
    const GroundLaw& law = ball.law_of(ball.ground);
    const double descent = -state.velocity.z;
    if (descent > kLandingSpeed) {
        BallBody body{ball.mass, ball.radius, state};
        const ImpulsePair impulse =
            ball_static_impact(solver_, body, kUp, law.restitution, law.friction);
        state = body.state;
        recording_.log_impact(time, ball.name, ground_name(ball.ground),
                              state.position - kUp * ball.radius, kUp, impulse);
    }
    if (state.velocity.z > kLandingSpeed) {
        ball.ground = Ground::none;
    } else {
        state.velocity.z = 0;
    }
}

void Balls::begin(Ball& ball, double time, const MotionState& state) {
    const MotionKind kind = ball.stretch.kind;
    ball.stretch = next_stretch(ball, time, state, around_);
    ++ball.version;
    if (ball.stretch.kind != kind)
        recording_.log(event_of(ball.stretch.kind), time, ball.name, ball.stretch.state.position);
}

void Balls::go_on(std::uint32_t index, double time) {
    Ball& ball = balls_[index];
    begin(ball, time, ball.stretch.state_at(time));
    recording_.keep(ball.track, time, ball.stretch.state);
}

void Balls::fall(std::uint32_t index, double time) {
    balls_[index].ground = Ground::none;
    go_on(index, time);
}

void Balls::finish(double time) {
    for (const Ball& ball : balls_)
        recording_.keep(ball.track, time, ball.stretch.state_at(time));
}

EnergySample Balls::energy(double time) const {
    EnergySample sample;
    sample.time = time;
    for (const Ball& ball : balls_) {
        const Vec3 v = ball.stretch.velocity_at(time);
        const Vec3 w = ball.stretch.angular_velocity_at(time);
        sample.kinetic += 0.5 * ball.mass * (v.dot(v) + 0.4 * ball.radius * ball.radius * w.dot(w));
        sample.potential -= ball.mass * around_.gravity.dot(ball.stretch.position_at(time));
    }
    return sample;
}

bool Balls::all_rest() const {
    return std::all_of(balls_.begin(), balls_.end(), [](const Ball& b) { return b.is_still(); });
}

}  // namespace carom::sim
