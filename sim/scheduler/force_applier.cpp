#include "sim/scheduler/force_applier.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "core/elementary.h"
#include "core/length.h"
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

ForceApplier::ForceApplier(const WorldDescription& world, const StaticEnvironment& environment,
                           Bodies& bodies, Recorder& recorder, BallPlacer& placer)
    : world_(world),
      environment_(environment),
      bodies_(bodies),
      recorder_(recorder),
      placer_(placer) {
    for (std::uint32_t i = 0; i < bodies.all().size(); ++i) {
        index_by_name_.emplace(bodies.all()[i].name(), i);
    }
}

void ForceApplier::apply(const DueAction& due) {
    const ForceEvent& event = world_.events[due.event];
    const auto found = index_by_name_.find(event.object);
    if (found == index_by_name_.end()) {
        return;
    }
    const std::uint32_t body = found->second;
    if (due.impulse_step >= 0) {
        apply_impulse_step(due, body);
    } else {
        std::visit([&](const auto& action) { apply(action, due, body); }, event.action);
    }
}

Quat ForceApplier::orientation_of(std::uint32_t body, double time) const {
    const MovingBody& turned = bodies_.all()[body];
    return turned.with_own_axes(turned.state_at(time)).orientation;
}

void ForceApplier::apply(const Force& force, const DueAction& due, std::uint32_t body) {
    const MotionState state = bodies_[body].state_at(due.time);
    recorder_.log_action(EventKind::force, due.time, due.time + force.duration,
                         bodies_[body].name(), state.position,
                         in_world(force.axes, orientation_of(body, due.time), force.newtons));
}

void ForceApplier::apply(const Torque& torque, const DueAction& due, std::uint32_t body) {
    const MotionState state = bodies_[body].state_at(due.time);
    recorder_.log_action(
        EventKind::torque, due.time, due.time + torque.duration, bodies_[body].name(),
        state.position,
        in_world(torque.axes, orientation_of(body, due.time), torque.newton_metres));
}

void ForceApplier::apply(const Impulse& impulse, const DueAction& due, std::uint32_t body) {
    const MotionState state = bodies_[body].state_at(due.time);
    const Vec3 p = in_world(impulse.axes, orientation_of(body, due.time), impulse.newton_seconds);
    const Vec3 arm = in_world(impulse.axes, orientation_of(body, due.time), impulse.at_point);
    recorder_.log_action(EventKind::impulse, due.time, due.time, bodies_[body].name(),
                         state.position, p);
    apply_impulse(body, due.time, p, arm.cross(p));
}

void ForceApplier::apply(const SetVelocity& velocity, const DueAction& due, std::uint32_t body) {
    const MotionState before = bodies_[body].state_at(due.time);
    MotionState after = before;
    after.velocity = velocity.linear.value_or(before.velocity);
    after.angular_velocity = velocity.angular.value_or(before.angular_velocity);
    recorder_.log_action(EventKind::velocity, due.time, due.time, bodies_[body].name(),
                         before.position, after.velocity);
    bodies_.change_velocities(body, due.time, before, after);
}

void ForceApplier::apply(const Strike& strike, const DueAction& due, std::uint32_t body) {
    const MovingBody& struck = bodies_[body];
    const MotionState before = struck.segment.state_at(due.time);
    const Vec3 aim = aim_direction(strike, before.position, due.time);
    if (aim == Vec3(0, 0, 0)) {
        recorder_.warn(
            {Subject::event(due.event), "toward",
             "strike on '" + struck.name() + "' at " + seconds(due.time) +
                 ": the target is straight above or below the ball; the strike is skipped"});
        return;
    }
    if (strike.tip.dot(strike.tip) > kMiscueOffset * kMiscueOffset) {
        recorder_.warn({Subject::event(due.event), "tip",
                        "strike on '" + struck.name() + "' at " + seconds(due.time) +
                            ": the tip is more than half a radius off centre, where it would "
                            "slip off the ball (a miscue)"});
    }
    const std::optional<StrikeResult> free = strike_ball(strike, aim, struck.rigid_at(due.time));
    if (!free) {
        return warn_of_unreached(strike, due, struck.name());
    }
    if (strike.toward) {
        aimed_strikes_.push_back({struck.name(), *strike.toward, due.time, due.event});
    }
    TouchingBalls touching = find_touching_balls(bodies_.balls(), body, due.time, environment_);
    if (touching.indices.size() == 1) {
        strike_free(*free, due.time, body);
    } else {
        strike_group(strike, aim, due.time, std::move(touching));
    }
}

void ForceApplier::apply(const PlaceBall& /*place*/, const DueAction& due, std::uint32_t body) {
    placer_.place(due.event, body, due.time);
}

void ForceApplier::apply(const RemoveBall& /*remove*/, const DueAction& due, std::uint32_t body) {
    placer_.remove(due.event, body, due.time);
}

void ForceApplier::warn_of_unreached(const Strike& strike, const DueAction& due,
                                     const std::string& ball) {
    const std::string reason =
        strike.speed ? "the ball moves away from the stick as fast as the stick comes, or faster"
                     : "the ball already has this speed";
    recorder_.warn({Subject::event(due.event), strike.speed ? "speed" : "ball_speed",
                    "strike on '" + ball + "' at " + seconds(due.time) + ": " + reason +
                        "; the strike is skipped"});
}

void ForceApplier::strike_free(const StrikeResult& result, double time, std::uint32_t body) {
    const MovingBody& struck = bodies_[body];
    const MotionState before = struck.segment.state_at(time);
    MotionState after = before;
    after.velocity += result.velocity;
    after.angular_velocity += result.angular_velocity;
    recorder_.log_strike(time, struck.name(), before.position, result.velocity,
                         struck.mass * length(result.velocity));
    bodies_.change_velocities(body, time, before, after);
}

void ForceApplier::strike_group(const Strike& strike, const Vec3& aim, double time,
                                TouchingBalls touching) {
    FrozenCluster& group = touching.group;
    const std::vector<RigidBody> before = group.balls;
    const ClusterStrikeResult push = strike_cluster(group, strike, aim, environment_.law.ball_ball);
    separate_balls(group, push);
    const auto ball_of = [&](std::size_t i) -> const MovingBody& {
        return bodies_[touching.indices[i]];
    };
    recorder_.log_strike(time, ball_of(group.struck).name(), before[group.struck].state.position,
                         push.velocity, push.impulse);
    std::vector<std::uint32_t> lasting;
    for (std::size_t i = 0; i < group.contacts.size(); ++i) {
        const TouchingPair& contact = group.contacts[i];
        const RigidBody& a = group.balls[contact.first];
        const RigidBody& b = group.balls[contact.second];
        if (push.contacts[i].normal * (1 / a.mass + 1 / b.mass) > kMinLoggedSpeed) {
            recorder_.log_impact(
                time, ball_of(contact.first).name(), ball_of(contact.second).name(),
                a.state.position - contact.normal * a.radius, contact.normal, push.contacts[i]);
        }
        const double separation = (a.state.velocity - b.state.velocity).dot(contact.normal);
        if (stays_in_contact(ball_of(contact.first), separation, contact.normal) ||
            stays_in_contact(ball_of(contact.second), separation, contact.normal)) {
            lasting.push_back(touching.indices[contact.first]);
            lasting.push_back(touching.indices[contact.second]);
        }
    }
    for (std::size_t i = 0; i < group.balls.size(); ++i) {
        bodies_.change_velocities(touching.indices[i], time, before[i].state, group.balls[i].state);
    }
    for (const std::uint32_t ball : lasting) {
        if (!bodies_[ball].is_in_solver()) {
            bodies_.enter_solver(ball, time);
        }
    }
}

void ForceApplier::apply_impulse_step(const DueAction& due, std::uint32_t body) {
    const ForceEvent& event = world_.events[due.event];
    const Quat orientation = orientation_of(body, due.time);
    if (const auto* force = std::get_if<Force>(&event.action)) {
        const double fraction = force->duration / impulse_step_count(force->duration);
        const Vec3 p = in_world(force->axes, orientation, force->newtons) * fraction;
        apply_impulse(body, due.time, p,
                      in_world(force->axes, orientation, force->at_point).cross(p));
    } else if (const auto* torque = std::get_if<Torque>(&event.action)) {
        const double fraction = torque->duration / impulse_step_count(torque->duration);
        apply_impulse(body, due.time, Vec3(0, 0, 0),
                      in_world(torque->axes, orientation, torque->newton_metres) * fraction);
    }
}

void ForceApplier::apply_impulse(std::uint32_t body, double time, const Vec3& impulse,
                                 const Vec3& angular_impulse) {
    const MovingBody& pushed = bodies_[body];
    const MotionState before = bodies_[body].state_at(time);
    MotionState after = before;
    after.velocity += impulse / pushed.mass;
    const Vec3 turned = to_body(before.orientation, angular_impulse);
    after.angular_velocity +=
        to_world(before.orientation, Vec3(turned.x / pushed.inertia.x, turned.y / pushed.inertia.y,
                                          turned.z / pushed.inertia.z));
    bodies_.change_velocities(body, time, before, after);
}

Vec3 ForceApplier::aim_direction(const Strike& strike, const Vec3& from, double time) const {
    if (strike.direction) {
        const SinCos direction = sin_cos(*strike.direction);
        return {direction.cos, direction.sin, 0};
    }
    const Vec3 target = strike.toward ? position_of(*strike.toward, time)
                                      : strike.toward_point.value_or(Vec3(0, 0, 0));
    const Vec3 d(target.x - from.x, target.y - from.y, 0);
    const double distance = std::sqrt(d.dot(d));
    return distance > 1e-9 ? d / distance : Vec3(0, 0, 0);
}

Vec3 ForceApplier::position_of(const std::string& name, double time) const {
    const auto found = index_by_name_.find(name);
    if (found != index_by_name_.end()) {
        return bodies_.all()[found->second].state_at(time).position;
    }
    for (const Body& body : world_.bodies) {
        if (body.name == name) {
            return body.pose.position;
        }
    }
    return {0, 0, 0};
}

std::vector<Diagnostic> ForceApplier::missed_strikes() const {
    std::vector<Diagnostic> warnings;
    for (const AimedStrike& strike : aimed_strikes_) {
        const auto& events = recorder_.events();
        const bool hit = std::any_of(events.begin(), events.end(), [&](const Event& event) {
            return event.kind == EventKind::impact && event.time >= strike.time &&
                   ((event.a == strike.ball && event.b == strike.target) ||
                    (event.a == strike.target && event.b == strike.ball));
        });
        if (!hit) {
            warnings.push_back({Subject::event(strike.event), "toward",
                                "strike on '" + strike.ball + "' at " + seconds(strike.time) +
                                    ": the ball never hit its target '" + strike.target + "'"});
        }
    }
    return warnings;
}

}  // namespace carom::sim
