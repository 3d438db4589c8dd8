#include "sim/scheduler/stepper.h"

#include <algorithm>
#include <array>

#include "sim/scheduler/step_loads.h"

namespace carom::sim {
namespace {

/// A ball that has touched nothing except level surfaces for so many steps leaves the solver.
constexpr int kFreeSteps = 3;

}  // namespace

Stepper::Stepper(const StaticEnvironment& environment, Bodies& bodies, Recorder& recorder)
    : environment_(environment),
      bodies_(bodies),
      recorder_(recorder),
      finder_(environment),
      sleep_(bodies, environment.gravity),
      bounces_(environment, bodies, finder_, recorder),
      trial_(world_, finder_, bounces_, environment.gravity, bodies.all()) {
    for (const MovingBody& body : bodies.all()) {
        world_.add(body, body.is_kinematic());
    }
}

/// Balls may have entered the solver, or changed in it, since the last step.
void Stepper::begin_window(double now) {
    for (std::uint32_t i = 0; i < bodies_.balls().size(); ++i) {
        MovingBody& ball = bodies_[i];
        if (ball.is_in_solver()) {
            ball.state = ball.segment.state_at(now);
        }
        if (ball.is_in_solver() && !ball.was_stepped) {
            ball.restart_rest_timer(now);
            ball.free_steps = 0;
        }
        ball.was_stepped = ball.is_in_solver();
    }
}

double Stepper::try_step(double now, double until) {
    begin_window(now);
    has_trial_step_ = true;
    std::vector<BodyContact> contacts = finder_.find(bodies_.all(), placements_of(bodies_.all()));
    while (sleep_.wake_by_contact(contacts, now)) {
        contacts = finder_.find(bodies_.all(), placements_of(bodies_.all()));
    }
    resolve_impacts(contacts, now);
    trial_.attempt(now, until, contacts);
    set_paths();
    return trial_.end();
}

/// Where moving kinematic bodies take part, the change of energy is their work.
void Stepper::resolve_impacts(const std::vector<BodyContact>& contacts, double now) {
    const auto energy = [this] {
        double sum = 0;
        for (const MovingBody& body : bodies_.all()) {
            sum += body.is_in_solver() && !body.is_kinematic() ? body.kinetic_energy() : 0;
        }
        return sum;
    };
    const bool is_driven = std::ranges::any_of(contacts, [this](const BodyContact& found) {
        return std::ranges::any_of(
            std::array{found.contact.first, found.contact.second}, [this](int number) {
                return number >= 0 && bodies_[static_cast<std::uint32_t>(number)].is_kinematic() &&
                       bodies_[static_cast<std::uint32_t>(number)].is_in_solver();
            });
    });
    const double before = is_driven ? energy() : 0;
    bounces_.resolve(contacts, now);
    bodies_.add_work(is_driven ? energy() - before : 0);
}

void Stepper::set_paths() {
    const double duration = trial_.end() - trial_.start();
    for (std::size_t slot = 0; slot < trial_.moving().size(); ++slot) {
        const auto number = static_cast<std::uint32_t>(trial_.moving()[slot]);
        const MovingBody& body = bodies_[number];
        const MotionState& end = trial_.motions()[slot].end;
        MotionState path = body.state;
        path.velocity = (end.position - body.state.position) / duration;
        path.angular_velocity = body.is_kinematic()
                                    ? trial_.motions()[slot].after.angular_velocity
                                    : (body.state.angular_velocity + end.angular_velocity) * 0.5;
        bodies_.set_path(number, trial_.start(), path);
    }
}

/// If no time is left in the step, all bodies stay where they are.
void Stepper::commit(double end) {
    has_trial_step_ = false;
    if (!trial_.shorten(end)) {
        for (const int number : trial_.moving()) {
            bodies_.end_step(static_cast<std::uint32_t>(number), end);
        }
        return;
    }
    log_contacts();
    for (std::size_t slot = 0; slot < trial_.moving().size(); ++slot) {
        const ode::StepMotion& motion = trial_.motions()[slot];
        bodies_[static_cast<std::uint32_t>(trial_.moving()[slot])].state = motion.end;
        bodies_.add_work(motion.work);
    }
    const std::vector<int> asleep = sleep_.falling_asleep(trial_.moving(), trial_.solved(), end);
    for (const int moving : trial_.moving()) {
        const auto number = static_cast<std::uint32_t>(moving);
        const bool falls_asleep = std::binary_search(asleep.begin(), asleep.end(), moving);
        if (bodies_[number].is_ball()) {
            finish_ball_step(number, end, falls_asleep);
        } else if (!bodies_[number].is_kinematic()) {
            finish_solid_step(number, end, falls_asleep);
        }
    }
}

void Stepper::log_contacts() {
    if (!recorder_.keeps_all()) {
        return;
    }
    for (const PairLoad& pair : pair_loads(trial_, bodies_.all())) {
        recorder_.add_contact(bodies_[static_cast<std::uint32_t>(pair.first)].name(),
                              finder_.name_of(pair.partner, bodies_.all()), pair.load);
    }
}

void Stepper::finish_solid_step(std::uint32_t number, double end, bool falls_asleep) {
    const MovingBody& body = bodies_[number];
    recorder_.add_sample(body.track, end, body.with_own_axes(body.state));
    if (falls_asleep) {
        bodies_.fall_asleep(number, end);
    } else {
        bodies_.end_step(number, end);
    }
}

/// The level surface that a ball touches; sets `touches_other` if it touches anything else.
SupportPlane Stepper::ground_under(std::uint32_t ball, bool& touches_other) const {
    const int number = static_cast<int>(ball);
    SupportPlane ground = SupportPlane::none;
    touches_other = false;
    for (const BodyContact& found : trial_.contacts()) {
        if (found.contact.first != number && found.contact.second != number) {
            continue;
        }
        const bool is_cloth = found.partner == ContactPartner(SupportPlane::cloth) &&
                              environment_.is_over_cloth(bodies_[ball].state.position);
        if (is_cloth || found.partner == ContactPartner(SupportPlane::floor)) {
            ground = is_cloth ? SupportPlane::cloth : SupportPlane::floor;
        } else {
            touches_other = true;
        }
    }
    return ground;
}

void Stepper::finish_ball_step(std::uint32_t number, double end, bool falls_asleep) {
    MovingBody& ball = bodies_[number];
    bool touches_other = false;
    const SupportPlane ground = ground_under(number, touches_other);
    MotionState& state = ball.state;
    const double height = ground_height(ground, environment_) + ball.radius;
    const bool stays_down = ground != SupportPlane::none && state.velocity.z < kLandingSpeed &&
                            state.position.z < height + 1e-4;
    if (stays_down) {
        state.position.z = height;
        state.velocity.z = 0;
    }
    ball.free_steps = touches_other ? 0 : ball.free_steps + 1;
    const bool is_free = ball.free_steps >= kFreeSteps;
    if (state.position.z < 0) {
        bodies_.log_below_cloth(number, end, state.position);
    }
    if (is_free && stays_down && environment_.downward_gravity > 0) {
        return bodies_.leave_solver(number, end, state, ground);
    }
    if (is_free && ground == SupportPlane::none) {
        return bodies_.leave_solver(number, end, state, SupportPlane::none);
    }
    recorder_.add_sample(ball.track, end, state);
    if (falls_asleep) {
        bodies_.fall_asleep(number, end);
    } else {
        bodies_.end_step(number, end);
    }
}

}  // namespace carom::sim
