#include "sim/scheduler/step_sleep.h"

#include <algorithm>

#include "core/length.h"

namespace carom::sim {
namespace {

/// A body whose points move more slowly than this (m/s) for that long (s) falls asleep.
constexpr double kSleepSpeed = 0.01;
constexpr double kBallSleepDelay = 0.1;
constexpr double kSolidSleepDelay = 0.12;
/// A body that leans on something without stable support, and does not slide for this long (s), is
/// held by friction.
constexpr double kLeaningSleepDelay = 0.5;
/// A body whose speed has risen by more than this (m/s) in the meantime is about to move.
constexpr double kRisingSpeed = 5e-4;
/// A sleeping body wakes when another one moves against it faster than this (m/s).
constexpr double kWakeSpeed = 0.01;

}  // namespace

void StepSleep::wake(StepBody& body, double time) {
    body.is_awake = true;
    body.restart_rest_timer(time);
    body.free_steps = 0;
    recorder_.add_key(body.track, time, body.with_own_axes(body.state));
    if (body.is_ball) {
        balls_.activate(static_cast<std::uint32_t>(&body - bodies_.data()), time);
    }
}

void StepSleep::wake_near(const Vec3& position, double distance, double time) {
    constexpr double kNear = 1e-3;  // m
    for (StepBody& body : bodies_) {
        const bool sleeps = body.is_in_ode && !body.is_awake && !body.is_kinematic();
        if (!sleeps ||
            length(body.state.position - position) > distance + body.bounding_radius() + kNear) {
            continue;
        }
        wake(body, time);
        wake_near(body.state.position, body.bounding_radius(), time);
    }
}

bool StepSleep::wake_by_contact(const std::vector<BodyContact>& contacts, double time) {
    bool is_changed = false;
    for (const BodyContact& found : contacts) {
        if (found.other < 0) {
            continue;
        }
        StepBody& a = bodies_[static_cast<std::size_t>(found.contact.first)];
        StepBody& b = bodies_[static_cast<std::size_t>(found.other)];
        if (a.is_awake == b.is_awake || (a.is_awake ? b : a).is_kinematic()) {
            continue;
        }
        const Vec3 relative =
            a.velocity_at(found.contact.point) - b.velocity_at(found.contact.point);
        // A kinematic body does not give way, however slow it is.
        const bool is_moved = (a.is_awake ? a : b).is_kinematic();
        if (length(relative) < kWakeSpeed && !is_moved) {
            continue;
        }
        wake(a.is_awake ? b : a, time);
        is_changed = true;
    }
    return is_changed;
}

bool StepSleep::is_slow_in_contact(const StepBody& body, int number,
                                   const SolvedContacts& solved) const {
    bool has_contact = false;
    bool is_slow = body.max_point_speed() < kSleepSpeed;
    for (const BodyContact& found : solved.contacts) {
        if (found.contact.first != number && found.other != number) {
            continue;
        }
        has_contact = true;
        const int partner = found.contact.first == number ? found.other : found.contact.first;
        if (partner < 0) {
            continue;
        }
        const StepBody& other = bodies_[static_cast<std::size_t>(partner)];
        const bool is_moved = other.is_kinematic() && other.is_awake;
        is_slow = is_slow && !is_moved && other.max_point_speed() < kSleepSpeed;
    }
    return is_slow && has_contact;
}

/// True if the body and all bodies that it touches have stable support.
bool StepSleep::is_supported_with_neighbours(const StepBody& body, int number,
                                             const SolvedContacts& solved) const {
    if (!is_stably_supported(body, number, solved, gravity_)) {
        return false;
    }
    return std::all_of(
        solved.contacts.begin(), solved.contacts.end(), [&](const BodyContact& found) {
            if (found.contact.first != number && found.other != number) {
                return true;
            }
            const int partner = found.contact.first == number ? found.other : found.contact.first;
            if (partner < 0) {
                return true;
            }
            const StepBody& other = bodies_[static_cast<std::size_t>(partner)];
            return !other.is_awake || other.is_kinematic() ||
                   is_stably_supported(other, partner, solved, gravity_);
        });
}

bool StepSleep::can_fall_asleep(StepBody& body, const SolvedContacts& solved, double time) const {
    const int number = static_cast<int>(&body - bodies_.data());
    const double speed = body.max_point_speed();
    if (!is_slow_in_contact(body, number, solved)) {
        body.restart_rest_timer(time);
    }
    body.least_speed = std::min(body.least_speed, speed);
    const double rested = time - body.slow_since;
    if (rested <= (body.is_ball ? kBallSleepDelay : kSolidSleepDelay)) {
        return false;
    }
    const bool is_rising = speed > body.least_speed + kRisingSpeed;
    const bool is_held = is_supported_with_neighbours(body, number, solved) ||
                         (rested > kLeaningSleepDelay && leans(number, solved, gravity_));
    return (!is_rising && is_held) || rested > time_to_tip(body, gravity_);
}

}  // namespace carom::sim
