#include "sim/scheduler/stepped_bodies.h"

#include <algorithm>
#include <limits>

#include "sim/scheduler/step_loads.h"

namespace carom::sim {
namespace {

/// A ball that has touched nothing except level surfaces for so many steps is deactivated.
constexpr int kFreeSteps = 3;

}  // namespace

SteppedBodies::SteppedBodies(const WorldDescription& world, const StaticEnvironment& environment,
                             Balls& balls, Recorder& recorder)
    : environment_(environment),
      balls_(balls),
      recorder_(recorder),
      finder_(environment),
      solids_(make_step_solids(world)),
      bodies_(make_step_bodies(balls.all(), solids_, environment.contacts)),
      sleep_(bodies_, balls, recorder, environment.gravity),
      bounces_(bodies_, finder_, world_, balls, recorder),
      trial_(world_, finder_, bounces_, environment.gravity, bodies_) {
    for (const StepBody& body : bodies_) {
        world_.add({body.mass, body.inertia, body.is_kinematic()});
    }
}

void SteppedBodies::start(double time) {
    for (StepBody& body : bodies_) {
        if (body.is_ball) {
            continue;
        }
        body.motion = {body.shape, time, body.state};
        body.restart_rest_timer(time);
        if (!body.is_kinematic()) {
            recorder_.add_key(body.track, time, body.with_own_axes(body.state));
        }
    }
}

void SteppedBodies::move_kinematic_bodies(double time) {
    for (StepBody& body : bodies_) {
        if (!body.is_kinematic()) {
            continue;
        }
        body.state = body.path->at(time);
        body.is_awake = body.path->is_moving_from(time);
        if (!body.is_awake) {
            body.state.velocity = body.state.angular_velocity = {0, 0, 0};
        }
        body.motion = {body.shape, time, body.state};
    }
}

double SteppedBodies::next_key_time(double time) const {
    double next = std::numeric_limits<double>::infinity();
    for (const StepBody& body : bodies_) {
        if (body.is_kinematic()) {
            next = std::min(next, body.path->next_key_time(time));
        }
    }
    return next;
}

bool SteppedBodies::is_active() const {
    const auto first_solid = bodies_.begin() + static_cast<std::ptrdiff_t>(balls_.all().size());
    return balls_.stepped_count() > 0 ||
           std::any_of(first_solid, bodies_.end(), [](const StepBody& b) { return b.is_awake; });
}

void SteppedBodies::adopt_balls(double time) {
    for (std::uint32_t i = 0; i < balls_.all().size(); ++i) {
        const Ball& ball = balls_.all()[i];
        StepBody& body = bodies_[i];
        const bool is_new = ball.is_stepped() && !(body.is_in_ode && body.is_awake);
        body.is_in_ode = ball.is_stepped() || ball.is_lying;
        body.is_awake = ball.is_stepped();
        if (body.is_in_ode) {
            body.state = ball.segment.state_at(time);
        }
        if (is_new) {
            body.restart_rest_timer(time);
            body.free_steps = 0;
        }
    }
}

double SteppedBodies::try_step(double now, double until) {
    adopt_balls(now);
    has_trial_step_ = true;
    std::vector<BodyContact> contacts = finder_.find(bodies_);
    while (sleep_.wake_by_contact(contacts, now)) {
        contacts = finder_.find(bodies_);
    }
    bounces_.resolve(contacts, now);
    trial_.attempt(now, until, contacts);
    publish_trial_paths();
    return trial_.end();
}

void SteppedBodies::publish_trial_paths() {
    const double duration = trial_.end() - trial_.start();
    for (std::size_t slot = 0; slot < trial_.moving().size(); ++slot) {
        const auto number = static_cast<std::uint32_t>(trial_.moving()[slot]);
        StepBody& body = bodies_[number];
        const MotionState& end = trial_.motions()[slot].end;
        MotionState path = body.state;
        path.velocity = (end.position - body.state.position) / duration;
        path.angular_velocity = body.is_kinematic()
                                    ? trial_.motions()[slot].after.angular_velocity
                                    : (body.state.angular_velocity + end.angular_velocity) * 0.5;
        if (body.is_ball) {
            balls_.set_trial_path(number, trial_.start(), path);
        } else {
            body.motion = {body.shape, trial_.start(), path};
        }
    }
}

void SteppedBodies::commit(double end) {
    has_trial_step_ = false;
    if (!trial_.shorten(end)) {
        return cancel_step(end);
    }
    log_contacts();
    for (std::size_t slot = 0; slot < trial_.moving().size(); ++slot) {
        bodies_[static_cast<std::size_t>(trial_.moving()[slot])].state = trial_.motions()[slot].end;
    }
    const std::vector<int> asleep = sleep_.falling_asleep(trial_.moving(), trial_.solved(), end);
    for (const int number : trial_.moving()) {
        StepBody& body = bodies_[static_cast<std::size_t>(number)];
        const bool falls_asleep = std::binary_search(asleep.begin(), asleep.end(), number);
        if (body.is_ball) {
            finish_ball_step(body, end, falls_asleep);
        } else if (!body.is_kinematic()) {
            finish_solid_step(body, end, falls_asleep);
        }
    }
}

/// No time is left in the step: all bodies stay where they are.
void SteppedBodies::cancel_step(double time) {
    for (const int moving : trial_.moving()) {
        const auto number = static_cast<std::uint32_t>(moving);
        StepBody& body = bodies_[number];
        if (body.is_ball) {
            balls_.set_stepped_state(number, time, body.state);
        } else {
            body.motion = {body.shape, time, body.state};
        }
    }
}

void SteppedBodies::log_contacts() {
    for (const PairLoad& pair : pair_loads(trial_, bodies_)) {
        const auto first = static_cast<std::size_t>(pair.first);
        recorder_.contacts().add(*bodies_[first].name,
                                 pair.other < 0
                                     ? finder_.info(pair.other).name
                                     : *bodies_[static_cast<std::size_t>(pair.other)].name,
                                 pair.load);
    }
}

/// A body that was woken and has not moved visibly has rested all the time.
void SteppedBodies::finish_solid_step(StepBody& body, double end, bool falls_asleep) {
    recorder_.add_sample(body.track, end, body.with_own_axes(body.state));
    if (falls_asleep) {
        if (!body.has_rested || body.has_moved_since_rest()) {
            recorder_.log(EventKind::resting, end, *body.name, body.state.position);
            body.has_rested = true;
            body.rested_at = {body.state.position, body.state.orientation};
        }
        body.is_awake = false;
        body.state.velocity = body.state.angular_velocity = {0, 0, 0};
        recorder_.add_key(body.track, end, body.with_own_axes(body.state));
    }
    body.motion = {body.shape, end, body.state};
}

/// The level surface that a ball touches; sets `touches_other` if it touches anything else.
Ground SteppedBodies::ground_under(const StepBody& ball, bool& touches_other) const {
    const int number = static_cast<int>(&ball - bodies_.data());
    Ground ground = Ground::none;
    touches_other = false;
    for (const BodyContact& found : trial_.contacts()) {
        if (found.contact.first != number && found.other != number) {
            continue;
        }
        const bool is_cloth =
            found.other == kCloth && environment_.is_over_cloth(ball.state.position);
        if (is_cloth || found.other == kFloor) {
            ground = is_cloth ? Ground::cloth : Ground::floor;
        } else {
            touches_other = true;
        }
    }
    return ground;
}

void SteppedBodies::finish_ball_step(StepBody& body, double end, bool falls_asleep) {
    const auto number = static_cast<std::uint32_t>(&body - bodies_.data());
    bool touches_other = false;
    const Ground ground = ground_under(body, touches_other);
    MotionState& state = body.state;
    const double height = ground_height(ground, environment_) + body.radius;
    const bool stays_down = ground != Ground::none && state.velocity.z < kLandingSpeed &&
                            state.position.z < height + 1e-4;
    if (stays_down) {
        state.position.z = height;
        state.velocity.z = 0;
    }
    body.free_steps = touches_other ? 0 : body.free_steps + 1;
    const bool is_free = body.free_steps >= kFreeSteps;
    if (state.position.z < 0) {
        balls_.log_below_cloth(number, end, state.position);
    }
    if (is_free && stays_down && environment_.downward_gravity > 0) {
        balls_.deactivate(number, end, state, ground);
    } else if (is_free && ground == Ground::none) {
        balls_.deactivate(number, end, state, Ground::none);
    } else if (falls_asleep) {
        recorder_.add_sample(body.track, end, state);
        balls_.put_to_rest(number, end, state);
        body.is_awake = false;
    } else {
        recorder_.add_sample(body.track, end, state);
        balls_.set_stepped_state(number, end, state);
    }
}

void SteppedBodies::change_solid_velocity(std::uint32_t number, double time, const Vec3& velocity,
                                          const Vec3& angular_velocity) {
    StepBody& body = bodies_[number];
    if (body.is_kinematic()) {
        return;
    }
    const MotionState before = body.state;
    body.state.velocity = velocity;
    body.state.angular_velocity = angular_velocity;
    recorder_.add_break(body.track, time, body.with_own_axes(before),
                        body.with_own_axes(body.state));
    body.motion = {body.shape, time, body.state};
    sleep_.wake(body, time);
    body.restart_rest_timer(time);
}

void SteppedBodies::add_energy(EnergySample& sample) const {
    for (const StepBody& body : bodies_) {
        if (body.is_ball || body.is_kinematic()) {
            continue;
        }
        sample.kinetic += body.kinetic_energy();
        sample.potential -= body.mass * environment_.gravity.dot(body.state.position);
    }
}

bool SteppedBodies::are_all_at_rest() const {
    return std::none_of(bodies_.begin(), bodies_.end(),
                        [](const StepBody& body) { return !body.is_ball && body.is_awake; });
}

void SteppedBodies::finish(double time) {
    for (const StepBody& body : bodies_) {
        if (!body.is_ball && !body.is_kinematic()) {
            recorder_.add_key(body.track, time, body.with_own_axes(body.state));
        }
    }
}

}  // namespace carom::sim
