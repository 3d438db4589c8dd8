#include "sim/scheduler/stepped_bodies.h"

#include <algorithm>
#include <cmath>

#include "sim/scheduler/contact_numbers.h"

namespace carom::sim {
namespace {

/// Bodies that were apart may overlap by this much (m) at a step's end; else the step is shortened
/// to when they met.
constexpr double kTouchDepth = 5e-6;
/// No step is made shorter than this (s) for that reason.
constexpr double kShortestStep = 1e-5;
/// A body moving less than this (m/s, its farthest point) for that long (s) falls asleep.
constexpr double kSleepSpeed = 0.01;
constexpr double kBallSleepDelay = 0.1;
constexpr double kBoxSleepDelay = 0.3;
/// A sleeper wakes when something comes against it faster than this (m/s).
constexpr double kWakeSpeed = 0.015;
/// Changes of velocity beyond what gravity does, in a step, that count as an impact (m/s).
constexpr double kKick = 0.02;
/// A ball that has touched nothing but level ground for so many steps is given back.
constexpr int kFreeSteps = 3;

double length(const Vec3& v) {
    return std::sqrt(v.dot(v));
}

StepBody ball_body(const Ball& ball) {
    StepBody body;
    body.name = ball.name;
    body.material = ball.material;
    body.track = ball.track;
    body.is_ball = true;
    body.radius = ball.radius;
    body.mass = ball.mass;
    body.inertia = Vec3(0.4 * ball.mass * ball.radius * ball.radius);
    return body;
}

StepBody box_body(const Body& from, const Vec3& size, std::size_t track) {
    StepBody body;
    body.name = from.name;
    body.material = from.material;
    body.track = track;
    body.half_size = size * 0.5;
    body.mass = from.mass;
    body.inertia = Vec3(size.y * size.y + size.z * size.z, size.x * size.x + size.z * size.z,
                        size.x * size.x + size.y * size.y) *
                   (from.mass / 12);
    body.state = {from.pose.position, from.pose.orientation, from.velocity, from.angular_velocity};
    body.is_in = body.is_awake = true;
    return body;
}

double farthest_speed(const StepBody& body) {
    return length(body.state.velocity) + body.reach() * length(body.state.angular_velocity);
}

ode::ImpactBody impact_body(const StepBody& body) {
    return {body.mass,
            body.inertia,
            {body.state.position, body.state.orientation},
            {body.state.velocity, body.state.angular_velocity}};
}

Vec3 velocity_at(const MotionState& state, const Vec3& point) {
    return state.velocity + state.angular_velocity.cross(point - state.position);
}

}  // namespace

SteppedBodies::SteppedBodies(const WorldDescription& world, const Surroundings& around,
                             Balls& balls, Recording& recording)
    : around_(around), balls_(balls), recording_(recording), finder_(around) {
    for (const Ball& ball : balls.all())
        bodies_.push_back(ball_body(ball));
    std::size_t track = 0;
    for (const Body& body : world.bodies) {
        if (body.kind != BodyKind::dynamic)
            continue;
        if (const auto* box = std::get_if<Box>(&body.shape))
            bodies_.push_back(box_body(body, box->size, track));
        ++track;
    }
    for (const StepBody& body : bodies_)
        world_.add({body.mass, body.inertia});
}

void SteppedBodies::start(double time) {
    for (StepBody& body : bodies_) {
        if (body.is_ball)
            continue;
        body.motion = {body.half_size, time, body.state};
        body.slow_since = time;
        recording_.keep(body.track, time, body.state);
    }
}

bool SteppedBodies::is_active() const {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const bool is_moving =
            bodies_[i].is_ball ? balls_.all()[i].is_stepped() : bodies_[i].is_awake;
        if (is_moving)
            return true;
    }
    return false;
}

void SteppedBodies::adopt_balls(double time) {
    for (std::uint32_t i = 0; i < balls_.all().size(); ++i) {
        const Ball& ball = balls_.all()[i];
        StepBody& body = bodies_[i];
        const bool is_new = ball.is_stepped() && !(body.is_in && body.is_awake);
        body.is_in = ball.is_stepped() || ball.is_lying;
        body.is_awake = ball.is_stepped();
        if (body.is_in)
            body.state = ball.stretch.state_at(time);
        if (is_new) {
            body.slow_since = time;
            body.free_steps = 0;
        }
    }
}

double SteppedBodies::try_step(double now, double until) {
    adopt_balls(now);
    step_start_ = now;
    step_end_ = until;
    is_trying_ = true;
    contacts_ = finder_.find(bodies_);
    wake_by_touch(now);
    bounce_balls(now);
    choose_moving();
    solve(step_end_ - step_start_);
    const double whole = step_end_ - step_start_;
    const double share = share_until_touch();
    if (share < 1) {
        step_end_ = now + std::max(share * whole, std::min(kShortestStep, whole));
        solve(step_end_ - step_start_);
    }
    const double duration = step_end_ - step_start_;
    for (std::size_t slot = 0; slot < moving_.size(); ++slot) {
        const auto number = static_cast<std::uint32_t>(moving_[slot]);
        StepBody& body = bodies_[number];
        MotionState path = motions_[slot].after;
        const Vec3 mean = (motions_[slot].end.position - motions_[slot].before.position) / duration;
        if (body.is_ball) {
            balls_.show_step(number, now, path, mean);
        } else {
            path.velocity = mean;
            body.motion = {body.half_size, now, path};
        }
    }
    return step_end_;
}

void SteppedBodies::wake_by_touch(double time) {
    bool is_changed = false;
    for (const FoundContact& found : contacts_) {
        if (found.other < 0)
            continue;
        StepBody& a = bodies_[static_cast<std::size_t>(found.contact.first)];
        StepBody& b = bodies_[static_cast<std::size_t>(found.other)];
        if (a.is_awake == b.is_awake)
            continue;
        const Vec3 relative =
            velocity_at(a.state, found.contact.point) - velocity_at(b.state, found.contact.point);
        if (length(relative) < kWakeSpeed)
            continue;
        wake(a.is_awake ? b : a, time);
        is_changed = true;
    }
    if (is_changed)
        contacts_ = finder_.find(bodies_);
}

double SteppedBodies::approach(const FoundContact& found) const {
    const ode::StepContact& contact = found.contact;
    Vec3 relative =
        velocity_at(bodies_[static_cast<std::size_t>(contact.first)].state, contact.point);
    if (found.other >= 0)
        relative -=
            velocity_at(bodies_[static_cast<std::size_t>(found.other)].state, contact.point);
    return -relative.dot(contact.normal);
}

/// Balls that come against something bounce pair by pair, the fastest first, until none approaches:
/// restitution in one solve for all contacts would add energy. What remains is for ODE's step.
void SteppedBodies::bounce_balls(double time) {
    constexpr int kMostBounces = 200;
    for (int i = 0; i < kMostBounces; ++i) {
        const FoundContact* fastest = nullptr;
        double speed = ode::kBounceSpeed;
        for (const FoundContact& found : contacts_) {
            if (!bodies_[static_cast<std::size_t>(found.contact.first)].is_ball)
                continue;
            const double candidate = approach(found);
            if (candidate > speed) {
                speed = candidate;
                fastest = &found;
            }
        }
        if (fastest == nullptr)
            break;
        bounce(*fastest, time);
    }
    for (FoundContact& found : contacts_) {
        if (bodies_[static_cast<std::size_t>(found.contact.first)].is_ball)
            found.contact.restitution = 0;
    }
}

void SteppedBodies::bounce(const FoundContact& found, double time) {
    const ode::StepContact& contact = found.contact;
    StepBody& ball = bodies_[static_cast<std::size_t>(contact.first)];
    StepBody* other = found.other >= 0 ? &bodies_[static_cast<std::size_t>(found.other)] : nullptr;
    const ode::ImpactContact impact{contact.point, contact.normal, contact.restitution,
                                    contact.friction};
    ode::ImpactResult result;
    if (other != nullptr) {
        result = balls_.solver().solve(impact_body(ball), impact_body(*other), impact);
    } else if (is_lining(finder_.info(found.other).material, contact.normal)) {
        BallBody body{ball.mass, ball.radius, ball.state};
        const ImpulsePair pair =
            lining_impact(body, contact.normal, contact.restitution, contact.friction);
        result.first = {body.state.velocity, body.state.angular_velocity};
        result.normal_impulse = pair.normal;
        result.tangential_impulse = pair.tangential;
    } else {
        result = balls_.solver().solve_static(impact_body(ball), impact);
    }
    take(ball, result.first, time);
    if (other != nullptr)
        take(*other, result.second, time);
    recording_.log_impact(
        time, ball.name, other != nullptr ? other->name : finder_.info(found.other).name,
        contact.point, contact.normal, {result.normal_impulse, result.tangential_impulse});
}

void SteppedBodies::take(StepBody& body, const ode::Velocities& velocities, double time) {
    if (!body.is_awake)
        wake(body, time);
    const MotionState before = body.state;
    body.state.velocity = velocities.linear;
    body.state.angular_velocity = velocities.angular;
    recording_.add_break(body.track, time, before, body.state);
}

void SteppedBodies::wake(StepBody& body, double time) {
    body.is_awake = true;
    body.slow_since = time;
    body.free_steps = 0;
    if (body.is_ball)
        balls_.hand_to_ode(static_cast<std::uint32_t>(&body - bodies_.data()), time);
}

void SteppedBodies::wake_near(const Vec3& place, double reach, double time) {
    constexpr double kNear = 1e-3;  // m
    for (StepBody& body : bodies_) {
        const bool sleeps = body.is_in && !body.is_awake;
        if (!sleeps || length(body.state.position - place) > reach + body.reach() + kNear)
            continue;
        wake(body, time);
        wake_near(body.state.position, body.reach(), time);
    }
}

void SteppedBodies::choose_moving() {
    moving_.clear();
    states_.clear();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (!bodies_[i].is_in || !bodies_[i].is_awake)
            continue;
        moving_.push_back(static_cast<int>(i));
        states_.push_back(bodies_[i].state);
    }
    step_contacts_.clear();
    for (const FoundContact& found : contacts_)
        step_contacts_.push_back(found.contact);
}

void SteppedBodies::solve(double duration) {
    world_.step(duration, around_.gravity, moving_, states_, step_contacts_, motions_, impulses_);
}

/// Which share of the step passes before bodies that were apart overlap.
double SteppedBodies::share_until_touch() const {
    std::map<std::pair<int, int>, bool> known;
    for (const FoundContact& found : contacts_)
        known[found.pair()] = true;
    std::vector<StepBody> trial = bodies_;
    const auto overlaps_at = [&](double share) {
        for (std::size_t slot = 0; slot < moving_.size(); ++slot) {
            const ode::StepMotion& motion = motions_[slot];
            MotionState& state = trial[static_cast<std::size_t>(moving_[slot])].state;
            state.position =
                motion.before.position + (motion.end.position - motion.before.position) * share;
            state.orientation =
                Imath::slerpShortestArc(motion.before.orientation, motion.end.orientation, share);
        }
        for (const FoundContact& found : finder_.find(trial)) {
            if (found.contact.depth > kTouchDepth && !known.contains(found.pair()))
                return true;
        }
        return false;
    };
    if (!overlaps_at(1))
        return 1;
    double low = 0;
    double high = 1;
    for (int i = 0; i < 9; ++i) {
        const double middle = 0.5 * (low + high);
        (overlaps_at(middle) ? high : low) = middle;
    }
    return low;
}

void SteppedBodies::commit(double end) {
    is_trying_ = false;
    if (end < step_end_ && end > step_start_)
        solve(end - step_start_);
    if (!(end > step_start_)) {
        for (std::size_t slot = 0; slot < moving_.size(); ++slot) {
            const auto number = static_cast<std::uint32_t>(moving_[slot]);
            StepBody& body = bodies_[number];
            if (body.is_ball) {
                balls_.carry(number, end, body.state);
            } else {
                body.motion = {body.half_size, end, body.state};
            }
        }
        return;
    }
    step_end_ = end;
    log_touches();
    for (std::size_t slot = 0; slot < moving_.size(); ++slot)
        record(slot, end);
    for (const int number : moving_)
        settle(static_cast<std::uint32_t>(number), end);
    last_pairs_.clear();
    for (const FoundContact& found : contacts_)
        last_pairs_[found.pair()] = true;
}

void SteppedBodies::record(std::size_t slot, double end) {
    const ode::StepMotion& motion = motions_[slot];
    const auto number = static_cast<std::size_t>(moving_[slot]);
    StepBody& body = bodies_[number];
    const Vec3 fall = around_.gravity * (end - step_start_);
    const Vec3 kick = motion.after.velocity - motion.before.velocity - fall;
    const Vec3 twist = motion.after.angular_velocity - motion.before.angular_velocity;
    if (length(kick) > kKick || length(twist) * body.reach() > kKick)
        recording_.add_break(body.track, step_start_, motion.before, motion.after);
    body.state = motion.end;
}

void SteppedBodies::log_touches() {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const FoundContact& found = contacts_[i];
        const bool is_first_of_pair = i == 0 || contacts_[i - 1].pair() != found.pair();
        if (!is_first_of_pair || last_pairs_.contains(found.pair()))
            continue;
        const StepBody& a = bodies_[static_cast<std::size_t>(found.contact.first)];
        if (a.is_ball || approach(found) < kKick)
            continue;
        ImpulsePair sum;
        for (std::size_t j = i; j < contacts_.size() && contacts_[j].pair() == found.pair(); ++j) {
            sum.normal += impulses_[j].normal;
            sum.tangential += impulses_[j].tangential;
        }
        const std::string& other = found.other >= 0
                                       ? bodies_[static_cast<std::size_t>(found.other)].name
                                       : finder_.info(found.other).name;
        recording_.log_impact(step_start_, a.name, other, found.contact.point, found.contact.normal,
                              sum);
    }
}

void SteppedBodies::settle(std::uint32_t number, double end) {
    StepBody& body = bodies_[number];
    bool has_contact = false;
    bool is_slow = farthest_speed(body) < kSleepSpeed;
    for (const FoundContact& found : contacts_) {
        const int me = static_cast<int>(number);
        if (found.contact.first != me && found.other != me)
            continue;
        has_contact = true;
        const int partner = found.contact.first == me ? found.other : found.contact.first;
        if (partner >= 0)
            is_slow =
                is_slow && farthest_speed(bodies_[static_cast<std::size_t>(partner)]) < kSleepSpeed;
    }
    if (!is_slow || !has_contact)
        body.slow_since = end;
    if (body.is_ball) {
        settle_ball(body, end);
        return;
    }
    if (end - body.slow_since > kBoxSleepDelay) {
        body.is_awake = false;
        recording_.add(body.track, end, body.state);
        body.state.velocity = body.state.angular_velocity = {0, 0, 0};
        recording_.keep(body.track, end, body.state);
        recording_.log(EventKind::resting, end, body.name, body.state.position);
    } else {
        recording_.add(body.track, end, body.state);
    }
    body.motion = {body.half_size, end, body.state};
}

void SteppedBodies::settle_ball(StepBody& body, double end) {
    const auto number = static_cast<std::uint32_t>(&body - bodies_.data());
    Ground ground = Ground::none;
    bool touches_other = false;
    for (const FoundContact& found : contacts_) {
        const int me = static_cast<int>(number);
        if (found.contact.first != me && found.other != me)
            continue;
        const bool is_cloth = found.other == kCloth && around_.is_over_cloth(body.state.position);
        if (is_cloth || found.other == kFloor) {
            ground = is_cloth ? Ground::cloth : Ground::floor;
        } else {
            touches_other = true;
        }
    }
    MotionState& state = body.state;
    const double height = ground_height(ground, around_) + body.radius;
    const bool stays_down = ground != Ground::none && state.velocity.z < kLandingSpeed &&
                            state.position.z < height + 1e-4;
    if (stays_down) {
        state.position.z = height;
        state.velocity.z = 0;
    }
    body.free_steps = touches_other ? 0 : body.free_steps + 1;
    const bool is_free = body.free_steps >= kFreeSteps;
    if (state.position.z < 0)
        balls_.note_sunk(number, end, state.position);
    if (is_free && stays_down && around_.downward_gravity > 0) {
        balls_.take_back(number, end, state, ground);
    } else if (is_free && ground == Ground::none) {
        balls_.take_back(number, end, state, Ground::none);
    } else if (end - body.slow_since > kBallSleepDelay) {
        recording_.add(body.track, end, state);
        balls_.lay_down(number, end, state);
    } else {
        recording_.add(body.track, end, state);
        balls_.carry(number, end, state);
    }
}

void SteppedBodies::change_box(std::uint32_t number, double time, const Vec3& velocity,
                               const Vec3& angular_velocity) {
    StepBody& body = bodies_[number];
    const MotionState before = body.state;
    body.state.velocity = velocity;
    body.state.angular_velocity = angular_velocity;
    recording_.add_break(body.track, time, before, body.state);
    body.motion = {body.half_size, time, body.state};
    if (!body.is_awake)
        wake(body, time);
    body.slow_since = time;
    wake_near(body.state.position, body.reach(), time);
}

void SteppedBodies::add_energy(EnergySample& sample) const {
    for (const StepBody& body : bodies_) {
        if (body.is_ball)
            continue;
        const MotionState& s = body.state;
        const Vec3 w = to_body(s.orientation, s.angular_velocity);
        sample.kinetic += 0.5 * body.mass * s.velocity.dot(s.velocity) +
                          0.5 * (body.inertia.x * w.x * w.x + body.inertia.y * w.y * w.y +
                                 body.inertia.z * w.z * w.z);
        sample.potential -= body.mass * around_.gravity.dot(s.position);
    }
}

bool SteppedBodies::all_rest() const {
    return std::none_of(bodies_.begin(), bodies_.end(),
                        [](const StepBody& body) { return !body.is_ball && body.is_awake; });
}

void SteppedBodies::finish(double time) {
    for (const StepBody& body : bodies_) {
        if (!body.is_ball)
            recording_.keep(body.track, time, body.state);
    }
}

}  // namespace carom::sim
