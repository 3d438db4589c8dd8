#include "sim/scheduler/bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/assert.h"
#include "core/finite.h"

namespace carom::sim {
namespace {

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
SupportPlane ground_at_start(const MovingBody& ball, const StaticEnvironment& environment) {
    constexpr double kThreshold = 1e-6;  // m
    const MotionState& state = ball.segment.state;
    if (environment.downward_gravity <= 0 || state.velocity.z > kLandingSpeed) {
        return SupportPlane::none;
    }
    const double bottom = state.position.z - ball.radius;
    if (std::abs(bottom) < kThreshold && environment.is_over_cloth(state.position)) {
        return SupportPlane::cloth;
    }
    if (environment.floor_height && std::abs(bottom - *environment.floor_height) < kThreshold) {
        return SupportPlane::floor;
    }
    return SupportPlane::none;
}

}  // namespace

bool stays_in_contact(const MovingBody& ball, double separation, const Vec3& normal) {
    return separation < kLandingSpeed &&
           (ball.ground == SupportPlane::none || std::abs(normal.z) > 1e-6 ||
            ball.law_of(ball.ground).lets_balls_go);
}

Bodies::Bodies(const WorldDescription& world, const StaticEnvironment& environment,
               Recorder& recorder)
    : environment_(environment),
      recorder_(recorder),
      bodies_(make_moving_bodies(world, environment)),
      ball_count_(static_cast<std::size_t>(std::ranges::count_if(bodies_, &MovingBody::is_ball))),
      return_(environment, bodies_),
      is_changed_(ball_count_, 0),
      solver_count_(
          static_cast<std::size_t>(std::ranges::count_if(bodies_, &MovingBody::is_in_solver))) {}

void Bodies::start(double time) {
    for (MovingBody& body : bodies_) {
        if (body.is_ball()) {
            body.ground = ground_at_start(body, environment_);
            set_segment(body, next_segment(body, time, body.segment.state, environment_));
            recorder_.add_key(body.track, time, body.segment.state);
            continue;
        }
        hold(body, time, body.state, MotionKind::stepped);
        body.restart_rest_timer(time);
        if (!body.is_kinematic()) {
            recorder_.add_key(body.track, time, body.with_own_axes(body.state));
        }
    }
}

void Bodies::change_state(std::uint32_t index, double time, const MotionState& before,
                          MotionState after) {
    MovingBody& ball = bodies_[index];
    if (ball.is_gone()) {
        return warn_of_gone(ball);
    }
    resolve_ground_impact(ball, time, after);
    begin_segment(ball, time, after, Mode::closed_form);
    recorder_.add_break(ball.track, time, before, ball.segment.state);
}

void Bodies::warn_of_gone(MovingBody& ball) {
    if (!ball.is_warned_of) {
        recorder_.warn({Subject::body(ball.name()), "",
                        "'" + ball.name() +
                            (ball.is_removed
                                 ? "' has been taken off the table: nothing moves it"
                                 : "' has left the table through its ball return: nothing moves it "
                                   "any more")});
    }
    ball.is_warned_of = true;
}

void Bodies::change_velocities(std::uint32_t index, double time, const MotionState& before,
                               const MotionState& after) {
    MovingBody& body = bodies_[index];
    if (body.is_kinematic()) {
        return;
    }
    if (body.is_ball()) {
        wake_island(index, time);
        if (!body.is_in_solver()) {
            return change_state(index, time, before, after);
        }
        hold(body, time, after, MotionKind::stepped);
        return recorder_.add_break(body.track, time, before, after);
    }
    body.state.velocity = after.velocity;
    body.state.angular_velocity = after.angular_velocity;
    recorder_.add_break(body.track, time, body.with_own_axes(before),
                        body.with_own_axes(body.state));
    wake_island(index, time);
    hold(body, time, body.state, MotionKind::stepped);
    body.restart_rest_timer(time);
}

void Bodies::resolve_ground_impact(MovingBody& ball, double time, MotionState& state) {
    if (ball.ground == SupportPlane::none) {
        return;
    }
    const SurfaceCoefficients& law = ball.law_of(ball.ground);
    if (environment_.downward_gravity <= 0) {
        ball.ground = SupportPlane::none;
        return;
    }
    const double descent = -state.velocity.z;
    if (descent > kLandingSpeed) {
        RigidBody body{ball.mass, ball.inertia, ball.radius, state};
        const ImpulsePair impulse =
            ball_static_impact(impact_solver_, body, kUp, law.restitution, law.friction);
        state = body.state;
        recorder_.log_impact(time, ball.name(), ground_name(ball.ground),
                             state.position - kUp * ball.radius, kUp, impulse);
    }
    if (state.velocity.z > kLandingSpeed) {
        ball.ground = SupportPlane::none;
    } else {
        state.velocity.z = 0;
    }
}

void Bodies::begin_segment(MovingBody& ball, double time, const MotionState& state, Mode mode) {
    const MotionKind kind = ball.segment.kind;
    set_mode(ball, mode);
    set_segment(ball, next_segment(ball, time, state, environment_));
    ball.has_rested = false;
    if (ball.segment.kind == MotionKind::flying && kind != MotionKind::flying) {
        ball.flight_event = recorder_.events().size();
    }
    if (ball.segment.kind != kind) {
        recorder_.log(event_of(ball.segment.kind), time, ball.name(), ball.segment.state.position);
    }
}

/// A segment of a body that the solver moves, or holds.
void Bodies::hold(MovingBody& body, double time, const MotionState& state, MotionKind kind) {
    MotionSegment segment;
    segment.kind = kind;
    segment.start = time;
    segment.state = state;
    body.ground = SupportPlane::none;
    if (body.is_ball()) {
        set_segment(body, segment);
    } else {
        body.segment = segment;
    }
}

void Bodies::set_mode(MovingBody& body, Mode mode) {
    solver_count_ -= body.is_in_solver() ? 1 : 0;
    body.mode = mode;
    solver_count_ += body.is_in_solver() ? 1 : 0;
}

void Bodies::set_segment(MovingBody& ball, const MotionSegment& segment) {
    CAROM_VALIDATE(is_finite(segment.state) && is_finite(segment.acceleration) &&
                   is_finite(segment.angular_acceleration));
    ball.segment = segment;
    if (ball.is_still()) {
        ball.rested_at = {segment.state.position, segment.state.orientation};
    }
    mark_changed(ball);
}

void Bodies::mark_changed(MovingBody& ball) {
    ++ball.version;
    const std::uint32_t index = index_of(ball);
    if (is_changed_[index] == 0) {
        changed_.push_back(index);
    }
    is_changed_[index] = 1;
}

void Bodies::invalidate_predictions() {
    for (MovingBody& body : bodies_) {
        if (body.is_ball()) {
            mark_changed(body);
        }
    }
}

std::vector<std::uint32_t> Bodies::take_changed() {
    std::vector<std::uint32_t> taken;
    taken.swap(changed_);
    for (const std::uint32_t index : taken) {
        is_changed_[index] = 0;
    }
    std::sort(taken.begin(), taken.end());
    return taken;
}

void Bodies::begin_next_segment(std::uint32_t index, double time) {
    MovingBody& ball = bodies_[index];
    const MotionState before = ball.segment.state_at(time);
    const MotionKind kind = ball.segment.kind;
    begin_segment(ball, time, before, ball.mode);
    if (ball.is_gone()) {  // it stops abruptly
        return recorder_.add_break(ball.track, time, before, ball.segment.state);
    }
    if (ball.segment.kind == kind && environment_.pull != Vec3(0, 0, 0)) {
        return recorder_.add_sample(ball.track, time, ball.segment.state);
    }
    recorder_.add_key(ball.track, time, ball.segment.state);
}

void Bodies::leave_ground(std::uint32_t index, double time) {
    bodies_[index].ground = SupportPlane::none;
    begin_next_segment(index, time);
}

void Bodies::retract_flight(const MovingBody& ball, double time) {
    if (ball.segment.kind == MotionKind::flying && ball.flight_event &&
        time - recorder_.events()[*ball.flight_event].time < kMinFlight) {
        recorder_.retract(*ball.flight_event);
    }
}

void Bodies::enter_solver(std::uint32_t index, double time) {
    MovingBody& ball = bodies_[index];
    const MotionState state = ball.segment.state_at(time);
    retract_flight(ball, time);
    set_mode(ball, Mode::solver);
    ball.is_restless = true;
    recorder_.add_key(ball.track, time, state);  // the closed form ends here
    hold(ball, time, state, MotionKind::stepped);
}

void Bodies::leave_solver(std::uint32_t index, double time, const MotionState& state,
                          SupportPlane ground) {
    MovingBody& ball = bodies_[index];
    ball.ground = ground;
    begin_segment(ball, time, state, Mode::closed_form);
    recorder_.add_key(ball.track, time, ball.segment.state);
}

void Bodies::end_step(std::uint32_t index, double time) {
    hold(bodies_[index], time, bodies_[index].state, MotionKind::stepped);
}

void Bodies::set_path(std::uint32_t index, double time, const MotionState& path) {
    hold(bodies_[index], time, path, MotionKind::stepped);
}

void Bodies::fall_asleep(std::uint32_t index, double time) {
    MovingBody& body = bodies_[index];
    const bool is_new = !body.has_rested || body.has_moved_since_rest();
    const Pose rested_at =
        is_new ? Pose{body.state.position, body.state.orientation} : body.rested_at;
    body.state.velocity = body.state.angular_velocity = {0, 0, 0};
    set_mode(body, Mode::asleep);
    hold(body, time, body.state, MotionKind::resting);
    body.rested_at = rested_at;
    body.has_rested = true;
    body.was_stepped = false;
    recorder_.add_key(body.track, time, body.with_own_axes(body.state));
    if (is_new) {
        recorder_.log(EventKind::resting, time, body.name(), body.state.position);
    }
    const int pocket = environment_.pocket_below(body.state.position);
    if (body.is_ball() && pocket >= 0 && !body.is_potted && !body.is_off_table) {
        return_.note_blocked(index, static_cast<std::size_t>(pocket), time);
    }
}

void Bodies::wake(std::uint32_t index, double time) {
    MovingBody& body = bodies_[index];
    if (!body.is_asleep() || body.is_kinematic()) {
        return;
    }
    body.state = body.state_at(time);
    body.restart_rest_timer(time);
    body.is_restless = false;
    body.free_steps = 0;
    body.was_stepped = true;
    recorder_.add_key(body.track, time, body.with_own_axes(body.state));
    set_mode(body, Mode::solver);
    hold(body, time, body.state, MotionKind::stepped);
}

void Bodies::wake_island(std::uint32_t index, double time) {
    const std::uint32_t island = bodies_[index].island;
    wake(index, time);
    bodies_[index].is_restless = true;
    for (std::uint32_t i = 0; island != 0 && i < bodies_.size(); ++i) {
        if (bodies_[i].island == island) {
            wake(i, time);
        }
    }
}

void Bodies::wake_around(std::uint32_t index, double time) {
    const Vec3 place = bodies_[index].state_at(time).position;
    const double reach = bodies_[index].bounding_radius() + kSolidMargin;
    for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
        const MovingBody& other = bodies_[i];
        if (i != index && other.is_asleep() && !other.is_kinematic() &&
            length(other.state_at(time).position - place) < reach + other.bounding_radius()) {
            wake_island(i, time);
        }
    }
    wake_island(index, time);
}

void Bodies::move_kinematic_bodies(double time) {
    for (MovingBody& body : bodies_) {
        if (!body.is_kinematic()) {
            continue;
        }
        const bool moves = body.path->is_moving_from(time);
        body.state = body.path->at(time);
        if (!moves) {
            body.state.velocity = body.state.angular_velocity = {0, 0, 0};
        }
        set_mode(body, moves ? Mode::solver : Mode::asleep);
        hold(body, time, body.state, moves ? MotionKind::stepped : MotionKind::resting);
    }
}

double Bodies::next_key_time(double time) const {
    double next = std::numeric_limits<double>::infinity();
    for (const MovingBody& body : bodies_) {
        if (body.is_kinematic()) {
            next = std::min(next, body.path->next_key_time(time));
        }
    }
    return next;
}

void Bodies::log_below_cloth(std::uint32_t index, double time, const Vec3& centre) {
    MovingBody& ball = bodies_[index];
    if (!environment_.has_cushions || ball.is_potted || ball.is_off_table) {
        return;
    }
    const int pocket = environment_.pocket_below(centre);
    if (pocket >= 0) {
        ball.is_potted = true;
        recorder_.log(EventKind::potted, time, ball.name(), centre,
                      environment_.table().pockets[static_cast<std::size_t>(pocket)].name);
        return_.note_potted(index, static_cast<std::size_t>(pocket), time);
    } else {
        ball.is_off_table = true;
        recorder_.log(EventKind::off_table, time, ball.name(), centre);
    }
}

void Bodies::leave_table(const BallReturn::Leaving& leaving, double time) {
    MovingBody& ball = bodies_[leaving.ball];
    const MotionState before = ball.segment.state_at(time);
    ball.ground = SupportPlane::none;
    ball.sinks_to = leaving.stops_at;
    begin_segment(ball, time, before, Mode::gone);
    recorder_.add_break(ball.track, time, before, ball.segment.state);
}

/// Whatever the ball did ends here.
void Bodies::move_to(MovingBody& ball, double time, const Vec3& place, Mode mode) {
    constexpr double kMinMove = 1e-5;  // m; less is no jump for a track
    return_.forget(index_of(ball));
    const MotionState before = ball.segment.state_at(time);
    ball.is_potted = ball.is_off_table = false;
    ball.is_warned_of = false;
    ball.flight_event.reset();
    MotionSegment still;
    still.kind = MotionKind::resting;
    still.start = time;
    still.state = {place, before.orientation, {0, 0, 0}, {0, 0, 0}};
    set_mode(ball, mode);
    set_segment(ball, ball.ground == SupportPlane::cloth
                          ? next_segment(ball, time, still.state, environment_)
                          : still);
    if ((place - before.position).length() > kMinMove) {
        recorder_.add_jump(ball.track, time, before, still.state);
    } else {
        recorder_.add_break(ball.track, time, before, still.state);
    }
}

void Bodies::put_down(std::uint32_t index, double time, const Vec2& place) {
    MovingBody& ball = bodies_[index];
    const Vec3 from = ball.segment.position_at(time);
    const Vec3 to(place.x, place.y, ball.radius);
    ball.is_removed = false;
    ball.ground = environment_.downward_gravity > 0 ? SupportPlane::cloth : SupportPlane::none;
    move_to(ball, time, to, Mode::closed_form);
    recorder_.add_put_back({ball.name(), time, from, to});
}

void Bodies::take_off(std::uint32_t index, double time, const Vec3& place) {
    MovingBody& ball = bodies_[index];
    ball.sinks_to = place.z;
    ball.is_removed = true;
    ball.ground = SupportPlane::none;
    move_to(ball, time, place, Mode::gone);
}

void Bodies::warn_of_balls_in_pocket_mouths() const {
    for (const MovingBody& ball : balls()) {
        const int pocket = environment_.pocket_below(ball.segment.state.position);
        if (!ball.is_still() || ball.is_potted || ball.is_off_table || pocket < 0) {
            continue;
        }
        recorder_.warn({Subject::body(ball.name()), "",
                        "'" + ball.name() +
                            "' is not potted: it rests in the mouth of the pocket '" +
                            environment_.table().pockets[static_cast<std::size_t>(pocket)].name +
                            "', held by other balls"});
    }
}

void Bodies::finish(double time) {
    for (const MovingBody& body : bodies_) {
        if (!body.is_kinematic()) {
            recorder_.add_key(body.track, time, body.with_own_axes(body.state_at(time)));
        }
    }
}

void Bodies::add_energy(double time, EnergySample& sample) const {
    sample.work = work_;
    for (const MovingBody& body : bodies_) {
        body.add_energy(time, environment_.gravity, sample);
    }
}

bool Bodies::are_all_at_rest() const {
    return std::ranges::all_of(bodies_, &MovingBody::is_still);
}

}  // namespace carom::sim
