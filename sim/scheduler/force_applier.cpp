#include "sim/scheduler/actions.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "core/elementary.h"
#include "sim/stick/strike.h"

namespace carom::sim {
namespace {

Vec3 in_world(Axes axes, const Quat& orientation, const Vec3& v) {
    return axes == Axes::world ? v : to_world(orientation, v);
}

std::string seconds(double time) {
    return fmt::format("{:.3f} s", time);
}

}  // namespace

Actions::Actions(const WorldDescription& world, Balls& balls, SteppedBodies& stepped,
                 Recording& recording)
    : world_(world), balls_(balls), stepped_(stepped), recording_(recording) {
    for (std::uint32_t i = 0; i < stepped.all().size(); ++i) {
        index_.emplace(*stepped.all()[i].name, i);
    }
}

void Actions::apply(const DueAction& due) {
    const ForceEvent& event = world_.events[due.event];
    const auto found = index_.find(event.object);
    if (found == index_.end()) {
        return;
    }
    const std::uint32_t body = found->second;
    if (due.kick >= 0) {
        kick(due, body);
    } else {
        std::visit([&](const auto& action) { begin(action, due, body); }, event.action);
    }
}

MotionState Actions::state_of(std::uint32_t body, double time) const {
    const StepBody& entry = stepped_.all()[body];
    return entry.is_ball ? balls_.all()[body].segment.state_at(time) : entry.state;
}

Quat Actions::axes_of(std::uint32_t body, double time) const {
    return stepped_.all()[body].seen(state_of(body, time)).orientation;
}

const std::string& Actions::name_of(std::uint32_t body) const {
    return *stepped_.all()[body].name;
}

void Actions::change(std::uint32_t body, double time, const MotionState& before,
                     const MotionState& after) {
    if (stepped_.all()[body].is_ball) {
        const Ball& ball = balls_.all()[body];
        if (ball.is_lying) {
            stepped_.wake_near(before.position, ball.radius, time);
        }
        if (ball.is_lying || ball.is_stepped()) {
            balls_.change_stepped(body, time, before, after);
        } else {
            balls_.change(body, time, before, after);
        }
    } else {
        stepped_.change_box(body, time, after.velocity, after.angular_velocity);
    }
}

void Actions::begin(const Force& force, const DueAction& due, std::uint32_t body) {
    const MotionState state = state_of(body, due.time);
    recording_.log_action(EventKind::force, due.time, due.time + force.duration, name_of(body),
                          state.position,
                          in_world(force.axes, axes_of(body, due.time), force.newtons));
}

void Actions::begin(const Torque& torque, const DueAction& due, std::uint32_t body) {
    const MotionState state = state_of(body, due.time);
    recording_.log_action(EventKind::torque, due.time, due.time + torque.duration, name_of(body),
                          state.position,
                          in_world(torque.axes, axes_of(body, due.time), torque.newton_metres));
}

void Actions::begin(const Impulse& impulse, const DueAction& due, std::uint32_t body) {
    const MotionState state = state_of(body, due.time);
    const Vec3 p = in_world(impulse.axes, axes_of(body, due.time), impulse.newton_seconds);
    const Vec3 arm = in_world(impulse.axes, axes_of(body, due.time), impulse.at_point);
    recording_.log_action(EventKind::impulse, due.time, due.time, name_of(body), state.position, p);
    push(body, due.time, p, arm.cross(p));
}

void Actions::begin(const SetVelocity& velocity, const DueAction& due, std::uint32_t body) {
    const MotionState before = state_of(body, due.time);
    MotionState after = before;
    after.velocity = velocity.linear.value_or(before.velocity);
    after.angular_velocity = velocity.angular.value_or(before.angular_velocity);
    recording_.log_action(EventKind::velocity, due.time, due.time, name_of(body), before.position,
                          after.velocity);
    change(body, due.time, before, after);
}

void Actions::begin(const Strike& strike, const DueAction& due, std::uint32_t body) {
    const Ball& struck = balls_[body];
    const MotionState before = struck.segment.state_at(due.time);
    const Vec3 aim = aim_of(strike, before.position, due.time);
    if (aim == Vec3(0, 0, 0)) {
        recording_.warn(
            {Subject::event(due.event), "toward",
             "strike on '" + struck.name + "' at " + seconds(due.time) +
                 ": the target is straight above or below the ball; nothing is struck"});
        return;
    }
    if (strike.tip.dot(strike.tip) > kMiscueOffset * kMiscueOffset) {
        recording_.warn({Subject::event(due.event), "tip",
                         "strike on '" + struck.name + "' at " + seconds(due.time) +
                             ": a tip more than half a radius off centre would miscue"});
    }
    const StrikeResult given = strike_ball(strike, aim, struck.mass, struck.radius);
    MotionState after = before;
    after.velocity += given.velocity;
    after.angular_velocity += given.angular_velocity;
    recording_.log_action(EventKind::strike, due.time, due.time, struck.name, before.position,
                          given.velocity);
    if (strike.toward) {
        aimed_.push_back({struck.name, *strike.toward, due.time, due.event});
    }
    change(body, due.time, before, after);
}

void Actions::kick(const DueAction& due, std::uint32_t body) {
    const ForceEvent& event = world_.events[due.event];
    const Quat orientation = axes_of(body, due.time);
    if (const auto* force = std::get_if<Force>(&event.action)) {
        const double fraction = force->duration / kick_count(force->duration);
        const Vec3 p = in_world(force->axes, orientation, force->newtons) * fraction;
        push(body, due.time, p, in_world(force->axes, orientation, force->at_point).cross(p));
    } else if (const auto* torque = std::get_if<Torque>(&event.action)) {
        const double fraction = torque->duration / kick_count(torque->duration);
        push(body, due.time, Vec3(0, 0, 0),
             in_world(torque->axes, orientation, torque->newton_metres) * fraction);
    }
}

void Actions::push(std::uint32_t body, double time, const Vec3& impulse,
                   const Vec3& angular_impulse) {
    const StepBody& pushed = stepped_.all()[body];
    const MotionState before = state_of(body, time);
    MotionState after = before;
    after.velocity += impulse / pushed.mass;
    const Vec3 turned = to_body(before.orientation, angular_impulse);
    after.angular_velocity +=
        to_world(before.orientation, Vec3(turned.x / pushed.inertia.x, turned.y / pushed.inertia.y,
                                          turned.z / pushed.inertia.z));
    change(body, time, before, after);
}

Vec3 Actions::aim_of(const Strike& strike, const Vec3& from, double time) const {
    if (strike.direction) {
        const SinCos direction = sin_cos(*strike.direction);
        return {direction.cos, direction.sin, 0};
    }
    const Vec3 target = strike.toward ? place_of(*strike.toward, time)
                                      : strike.toward_point.value_or(Vec3(0, 0, 0));
    const Vec3 d(target.x - from.x, target.y - from.y, 0);
    const double distance = std::sqrt(d.dot(d));
    return distance > 1e-9 ? d / distance : Vec3(0, 0, 0);
}

Vec3 Actions::place_of(const std::string& name, double time) const {
    const auto found = index_.find(name);
    if (found != index_.end()) {
        return state_of(found->second, time).position;
    }
    for (const Body& body : world_.bodies) {
        if (body.name == name) {
            return body.pose.position;
        }
    }
    return {0, 0, 0};
}

std::vector<Diagnostic> Actions::missed_strikes() const {
    std::vector<Diagnostic> warnings;
    for (const Aimed& aimed : aimed_) {
        const auto& events = recording_.events();
        const bool hit = std::any_of(events.begin(), events.end(), [&](const Event& event) {
            return event.kind == EventKind::impact && event.time >= aimed.time &&
                   ((event.a == aimed.ball && event.b == aimed.target) ||
                    (event.a == aimed.target && event.b == aimed.ball));
        });
        if (!hit) {
            warnings.push_back({Subject::event(aimed.event), "toward",
                                "strike on '" + aimed.ball + "' at " + seconds(aimed.time) +
                                    ": it never touched '" + aimed.target +
                                    "', which it was aimed at"});
        }
    }
    return warnings;
}

}  // namespace carom::sim
