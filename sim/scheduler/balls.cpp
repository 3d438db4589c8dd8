#include "sim/scheduler/balls.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/finite.h"

namespace carom::sim {
namespace {

const Vec3 kUp(0, 0, 1);

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
        case MotionKind::stepped:  // never logged
            break;
    }
    return EventKind::airborne;
}

/// The level surface on which a ball rests or moves at the start.
Ground ground_at_start(const Ball& ball, const StaticEnvironment& environment) {
    constexpr double kClose = 1e-6;  // m
    const MotionState& state = ball.segment.state;
    if (environment.downward_gravity <= 0 || state.velocity.z > kLandingSpeed) {
        return Ground::none;
    }
    const double bottom = state.position.z - ball.radius;
    if (std::abs(bottom) < kClose && environment.is_over_cloth(state.position)) {
        return Ground::cloth;
    }
    if (environment.floor_height && std::abs(bottom - *environment.floor_height) < kClose) {
        return Ground::floor;
    }
    return Ground::none;
}

}  // namespace

bool stays_in_contact(const Ball& ball, double separation, const Vec3& normal) {
    return separation < kLandingSpeed && (ball.ground == Ground::none || std::abs(normal.z) > 1e-6);
}

Balls::Balls(const WorldDescription& world, const StaticEnvironment& environment,
             Recorder& recorder)
    : environment_(environment),
      recorder_(recorder),
      balls_(make_balls(world, environment)),
      return_(environment, balls_),
      is_changed_(balls_.size(), 0) {}

void Balls::start(double time) {
    for (Ball& ball : balls_) {
        ball.ground = ground_at_start(ball, environment_);
        set_segment(ball, next_segment(ball, time, ball.segment.state, environment_));
        recorder_.add_key(ball.track, time, ball.segment.state);
    }
}

void Balls::change_state(std::uint32_t index, double time, const MotionState& before,
                         MotionState after) {
    Ball& ball = balls_[index];
    if (ball.is_returned()) {
        return warn_of_returned(ball);
    }
    resolve_ground_impact(ball, time, after);
    begin_segment(ball, time, after);
    recorder_.add_break(ball.track, time, before, ball.segment.state);
}

void Balls::warn_of_returned(Ball& ball) {
    if (!ball.is_warned_of) {
        recorder_.warn({Subject::body(ball.name), "",
                        "'" + ball.name +
                            (ball.is_removed
                                 ? "' has been taken off the table: nothing moves it"
                                 : "' has left the table through its ball return: nothing moves it "
                                   "any more")});
    }
    ball.is_warned_of = true;
}

void Balls::change_stepped_state(std::uint32_t index, double time, const MotionState& before,
                                 const MotionState& after) {
    set_stepped_state(index, time, after);
    recorder_.add_break(balls_[index].track, time, before, after);
}

void Balls::resolve_ground_impact(Ball& ball, double time, MotionState& state) {
    if (ball.ground == Ground::none) {
        return;
    }
    const GroundLaw& law = ball.law_of(ball.ground);
    if (environment_.downward_gravity <= 0) {
        ball.ground = Ground::none;
        return;
    }
    const double descent = -state.velocity.z;
    if (descent > kLandingSpeed) {
        BallBody body{ball.mass, ball.radius, state};
        const ImpulsePair impulse =
            ball_static_impact(solver_, body, kUp, law.restitution, law.friction);
        state = body.state;
        recorder_.log_impact(time, ball.name, ground_name(ball.ground),
                             state.position - kUp * ball.radius, kUp, impulse);
    }
    if (state.velocity.z > kLandingSpeed) {
        ball.ground = Ground::none;
    } else {
        state.velocity.z = 0;
    }
}

void Balls::begin_segment(Ball& ball, double time, const MotionState& state) {
    const MotionKind kind = ball.segment.kind;
    set_segment(ball, next_segment(ball, time, state, environment_));
    ball.is_lying = ball.has_lain = false;
    if (ball.segment.kind == MotionKind::flying && kind != MotionKind::flying) {
        ball.flight_event = recorder_.events().size();
    }
    if (ball.segment.kind != kind) {
        recorder_.log(event_of(ball.segment.kind), time, ball.name, ball.segment.state.position);
    }
}

void Balls::set_segment(Ball& ball, const MotionSegment& segment) {
    if (ball.is_stepped()) {
        --stepped_count_;
    }
    CAROM_VALIDATE(is_finite(segment.state) && is_finite(segment.acceleration) &&
                   is_finite(segment.angular_acceleration));
    ball.segment = segment;
    if (ball.is_still()) {
        ball.rested_at = segment.state.position;
    }
    if (ball.is_stepped()) {
        ++stepped_count_;
    }
    mark_changed(ball);
}

void Balls::mark_changed(Ball& ball) {
    ++ball.version;
    const auto index = static_cast<std::uint32_t>(&ball - balls_.data());
    if (is_changed_[index] == 0) {
        changed_.push_back(index);
    }
    is_changed_[index] = 1;
}

void Balls::invalidate_predictions() {
    for (Ball& ball : balls_) {
        mark_changed(ball);
    }
}

std::vector<std::uint32_t> Balls::take_changed() {
    std::vector<std::uint32_t> taken;
    taken.swap(changed_);
    for (const std::uint32_t index : taken) {
        is_changed_[index] = 0;
    }
    std::sort(taken.begin(), taken.end());
    return taken;
}

void Balls::begin_next_segment(std::uint32_t index, double time) {
    Ball& ball = balls_[index];
    const MotionState before = ball.segment.state_at(time);
    begin_segment(ball, time, before);
    if (ball.is_returned()) {  // it stops abruptly
        return recorder_.add_break(ball.track, time, before, ball.segment.state);
    }
    recorder_.add_key(ball.track, time, ball.segment.state);
}

void Balls::leave_ground(std::uint32_t index, double time) {
    balls_[index].ground = Ground::none;
    begin_next_segment(index, time);
}

void Balls::retract_flight(const Ball& ball, double time) {
    if (ball.segment.kind == MotionKind::flying && ball.flight_event &&
        time - recorder_.events()[*ball.flight_event].time < kLeastFlight) {
        recorder_.retract(*ball.flight_event);
    }
}

void Balls::activate(std::uint32_t index, double time) {
    retract_flight(balls_[index], time);
    set_stepped_state(index, time, balls_[index].segment.state_at(time));
}

void Balls::set_stepped_state(std::uint32_t index, double time, const MotionState& state) {
    Ball& ball = balls_[index];
    ball.ground = Ground::none;
    ball.is_lying = false;
    MotionSegment segment;
    segment.kind = MotionKind::stepped;
    segment.start = time;
    segment.state = state;
    set_segment(ball, segment);
}

void Balls::deactivate(std::uint32_t index, double time, const MotionState& state, Ground ground) {
    Ball& ball = balls_[index];
    ball.ground = ground;
    begin_segment(ball, time, state);
    recorder_.add_key(ball.track, time, ball.segment.state);
}

void Balls::log_below_cloth(std::uint32_t index, double time, const Vec3& centre) {
    Ball& ball = balls_[index];
    if (!environment_.has_cushions || ball.is_potted || ball.is_off_table) {
        return;
    }
    const int pocket = environment_.pocket_below(centre);
    if (pocket >= 0) {
        ball.is_potted = true;
        recorder_.log(EventKind::potted, time, ball.name, centre,
                      environment_.table().pockets[static_cast<std::size_t>(pocket)].name);
        return_.note_potted(index, static_cast<std::size_t>(pocket), time);
    } else {
        ball.is_off_table = true;
        recorder_.log(EventKind::off_table, time, ball.name, centre);
    }
}

void Balls::leave_table(const BallReturn::Leaving& leaving, double time) {
    Ball& ball = balls_[leaving.ball];
    const MotionState before = ball.segment.state_at(time);
    ball.ground = Ground::none;
    ball.sinks_to = leaving.stops_at;
    begin_segment(ball, time, before);
    recorder_.add_break(ball.track, time, before, ball.segment.state);
}

/// Whatever the ball did ends here.
void Balls::move_to(Ball& ball, double time, const Vec3& place) {
    constexpr double kLeastMove = 1e-5;  // m; less is no jump for a track
    return_.forget(static_cast<std::uint32_t>(&ball - balls_.data()));
    const MotionState before = ball.segment.state_at(time);
    ball.is_lying = ball.is_potted = ball.is_off_table = false;
    ball.is_warned_of = false;
    ball.flight_event.reset();
    MotionSegment still;
    still.kind = MotionKind::resting;
    still.start = time;
    still.state = {place, before.orientation, {0, 0, 0}, {0, 0, 0}};
    set_segment(ball, still);
    if ((place - before.position).length() > kLeastMove) {
        recorder_.add_jump(ball.track, time, before, still.state);
    } else {
        recorder_.add_break(ball.track, time, before, still.state);
    }
}

void Balls::put_down(std::uint32_t index, double time, const Vec2& place) {
    Ball& ball = balls_[index];
    const Vec3 from = ball.segment.position_at(time);
    const Vec3 to(place.x, place.y, ball.radius);
    ball.sinks_to.reset();
    ball.is_removed = false;
    ball.ground = environment_.downward_gravity > 0 ? Ground::cloth : Ground::none;
    move_to(ball, time, to);
    recorder_.add_put_back({ball.name, time, from, to});
}

void Balls::take_off(std::uint32_t index, double time, const Vec3& place) {
    Ball& ball = balls_[index];
    ball.sinks_to = place.z;
    ball.is_removed = true;
    ball.ground = Ground::none;
    move_to(ball, time, place);
}

void Balls::warn_of_balls_in_pocket_mouths() const {
    for (const Ball& ball : balls_) {
        const int pocket = environment_.pocket_below(ball.segment.state.position);
        if (!ball.is_still() || ball.is_potted || ball.is_off_table || pocket < 0) {
            continue;
        }
        recorder_.warn({Subject::body(ball.name), "",
                        "'" + ball.name + "' is not potted: it rests in the mouth of the pocket '" +
                            environment_.table().pockets[static_cast<std::size_t>(pocket)].name +
                            "', held by other balls"});
    }
}

void Balls::put_to_rest(std::uint32_t index, double time, MotionState state) {
    Ball& ball = balls_[index];
    const bool is_new = !ball.has_lain || ball.has_moved_since_rest();
    const Vec3 rested_at = ball.rested_at;
    state.velocity = state.angular_velocity = {0, 0, 0};
    set_stepped_state(index, time, state);
    MotionSegment still = ball.segment;
    still.kind = MotionKind::resting;
    set_segment(ball, still);
    ball.is_lying = ball.has_lain = true;
    recorder_.add_key(ball.track, time, state);
    if (is_new) {
        recorder_.log(EventKind::resting, time, ball.name, state.position);
    } else {
        ball.rested_at = rested_at;
    }
    const int pocket = environment_.pocket_below(state.position);
    if (pocket >= 0 && !ball.is_potted && !ball.is_off_table) {
        return_.note_blocked(index, static_cast<std::size_t>(pocket), time);
    }
}

void Balls::finish(double time) {
    for (const Ball& ball : balls_) {
        recorder_.add_key(ball.track, time, ball.segment.state_at(time));
    }
}

void Balls::add_energy(double time, EnergySample& sample) const {
    for (const Ball& ball : balls_) {
        const Vec3 v = ball.segment.velocity_at(time);
        const Vec3 w = ball.segment.angular_velocity_at(time);
        sample.kinetic += 0.5 * ball.mass * (v.dot(v) + 0.4 * ball.radius * ball.radius * w.dot(w));
        sample.potential -= ball.mass * environment_.gravity.dot(ball.segment.position_at(time));
    }
}

bool Balls::are_all_at_rest() const {
    return std::all_of(balls_.begin(), balls_.end(), [](const Ball& b) { return b.is_still(); });
}

}  // namespace carom::sim
