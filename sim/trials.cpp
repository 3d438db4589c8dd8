#include "sim/trials.h"

#include <algorithm>
#include <utility>

#include "sim/scheduler/prepared_world.h"
#include "sim/scheduler/scheduler.h"

namespace carom::sim {
namespace {

/// The world without what only its static environment needs, and places of balls.
WorldDescription without_meshes(WorldDescription world) {
    for (Body& body : world.bodies) {
        if (auto* mesh = std::get_if<TriangleMesh>(&body.shape)) {
            *mesh = {};
        }
    }
    return world;
}

std::vector<std::string> moving_names(const WorldDescription& world) {
    std::vector<std::string> names;
    for (const Body& body : world.bodies) {
        if (body.kind == BodyKind::dynamic) {
            names.push_back(body.name);
        }
    }
    return names;
}

}  // namespace

struct Trials::Shared {
    explicit Shared(WorldDescription from)
        : prepared(from),
          names(moving_names(from)),
          lean(without_meshes(from)),
          world(std::move(from)) {}

    PreparedWorld prepared;
    std::vector<std::string> names;
    WorldDescription lean;
    WorldDescription world;
};

Trials::Trials(WorldDescription world)
    : shared_(std::make_unique<const Shared>(std::move(world))) {}
Trials::~Trials() = default;

const WorldDescription& Trials::world() const {
    return shared_->world;
}

const std::vector<std::string>& Trials::names() const {
    return shared_->names;
}

std::optional<Outcome> Trials::run(std::vector<ForceEvent> events,
                                   const TrialLimits& limits) const {
    const bool places_balls = std::ranges::any_of(events, [](const ForceEvent& event) {
        return std::holds_alternative<PlaceBall>(event.action);
    });
    WorldDescription world = places_balls ? shared_->world : shared_->lean;
    world.events = std::move(events);
    require_none(find_event_problems(world));
    if (places_balls) {
        require_free_places(world, shared_->prepared.environment);
    }
    Scheduler scheduler(world, shared_->prepared.environment,
                        limits.keeps_motion ? Record::all : Record::outcome);
    scheduler.stop_at(&limits.is_answered);
    WorkContext context;
    context.stop = limits.stop;
    if (!scheduler.run(context, limits.max_steps)) {
        return std::nullopt;
    }
    Timeline timeline = scheduler.take_timeline();
    Outcome outcome;
    outcome.end_time = timeline.end_time;
    outcome.is_stopped = scheduler.was_stopped();
    outcome.states = scheduler.last_states();
    if (limits.keeps_motion) {
        outcome.events = timeline.events;
        outcome.warnings = timeline.warnings;
        outcome.motion = std::move(timeline);
    } else {
        outcome.events = std::move(timeline.events);
        outcome.warnings = std::move(timeline.warnings);
    }
    return outcome;
}

}  // namespace carom::sim
