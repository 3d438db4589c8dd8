// The events of a shot.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <variant>

#include "pipeline/studio/shot_state.h"
#include "pipeline/studio/triple.h"

namespace carom::studio {

namespace {

/// Where the object's centre is at that time, if it is known.
std::optional<Vec3> position_at(const std::string& name, double time, const pipeline::Shot& shot,
                                const sim::Timeline& timeline) {
    if (const sim::Track* track = timeline.find(name)) {
        return track->sample(time).position;
    }
    const auto body = std::ranges::find(shot.world.bodies, name, &sim::Body::name);
    return body == shot.world.bodies.end() ? std::nullopt : std::optional(body->pose.position);
}

struct FillEvent {
    ShotEvent& message;
    const pipeline::Shot& shot;
    const sim::Timeline& timeline;

    void operator()(const sim::Force& force) const {
        message.kind = "force";
        message.vector = triple(force.newtons);
        message.duration = force.duration;
    }
    void operator()(const sim::Torque& torque) const {
        message.kind = "torque";
        message.vector = triple(torque.newton_metres);
        message.duration = torque.duration;
    }
    void operator()(const sim::Impulse& impulse) const {
        message.kind = "impulse";
        message.vector = triple(impulse.newton_seconds);
    }
    void operator()(const sim::SetVelocity& velocity) const {
        message.kind = "velocity";
        message.vector = triple(velocity.linear.value_or(Vec3(0, 0, 0)));
    }
    void operator()(const sim::Strike& strike) const {
        message.kind = "strike";
        message.ball_speed = strike.ball_speed.has_value();
        message.speed = strike.ball_speed.value_or(strike.speed.value_or(0));
        message.elevation = strike.elevation;
        message.tip = {strike.tip.x, strike.tip.y};
        message.toward = strike.toward.value_or("");
        message.direction = strike.direction.value_or(aim_of(strike));
        message.vector = {std::cos(message.direction), std::sin(message.direction), 0};
    }

    void operator()(const sim::PlaceBall& place) const {
        message.kind = "place";
        message.vector = {place.at.x, place.at.y, 0};
    }
    void operator()(const sim::RemoveBall& /*remove*/) const { message.kind = "remove"; }

  private:
    /// The direction towards the target; 0 if a place is not known.
    [[nodiscard]] double aim_of(const sim::Strike& strike) const {
        const auto from = position_at(message.object, message.time, shot, timeline);
        const auto to = strike.toward ? position_at(*strike.toward, message.time, shot, timeline)
                                      : strike.toward_point;
        return from && to ? std::atan2(to->y - from->y, to->x - from->x) : 0;
    }
};

bool is_of_kind(sim::EventKind kind, const sim::ForceEvent& event) {
    constexpr std::array kKinds{sim::EventKind::force,   sim::EventKind::torque,
                                sim::EventKind::impulse, sim::EventKind::velocity,
                                sim::EventKind::strike,  sim::EventKind::placed,
                                sim::EventKind::removed};
    return kKinds.at(event.action.index()) == kind;
}

/// The start of the event in the timeline that no earlier event has; empty if it never started.
std::optional<double> start_of(const sim::ForceEvent& event, const sim::Timeline& timeline,
                               std::set<const sim::Event*>& used) {
    for (const sim::Event& logged : timeline.events) {
        if (logged.a == event.object && is_of_kind(logged.kind, event) &&
            logged.time >= event.time && used.insert(&logged).second) {
            return logged.time;
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<ShotEvent> event_messages(const pipeline::Shot& shot, const sim::Timeline& timeline) {
    std::set<const sim::Event*> used;
    std::vector<ShotEvent> messages;
    for (const sim::ForceEvent& event : shot.world.events) {
        ShotEvent message;
        message.path = {"events", std::to_string(messages.size())};
        message.object = event.object;
        message.triggered = event.trigger.has_value();
        message.time = event.time + event.after;
        const std::optional<double> start = start_of(event, timeline, used);
        if (message.triggered && start) {
            message.time = *start;
        }
        std::visit(FillEvent{message, shot, timeline}, event.action);
        messages.push_back(std::move(message));
    }
    return messages;
}

}  // namespace carom::studio
