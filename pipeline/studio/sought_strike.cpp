#include "pipeline/studio/sought_strike.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "core/error.h"
#include "pipeline/solve/question.h"
#include "pipeline/studio/shot_state.h"

namespace carom::studio {

namespace {

constexpr double kNewStrike = 0.5;  // s, after the last event

/// When the next strike comes after `time`.
double next_strike(const sim::Timeline& timeline, double time) {
    for (const sim::Event& event : timeline.events) {
        if (event.kind == sim::EventKind::strike && event.time > time) {
            return event.time;
        }
    }
    return std::numeric_limits<double>::infinity();
}

bool is_ball(const sim::WorldDescription& world, const std::string& name) {
    const auto body = std::ranges::find(world.bodies, name, &sim::Body::name);
    return body != world.bodies.end() && body->kind == sim::BodyKind::dynamic &&
           std::holds_alternative<sim::Sphere>(body->shape);
}

pipeline::solve::Happening potted(const Pot& pot) {
    pipeline::solve::Happening happening;
    happening.trigger.kind = sim::Trigger::Kind::potted;
    happening.trigger.a = pot.ball;
    happening.pocket = pot.pocket;
    return happening;
}

/// That for whom the shot's `solve` finds the strike, or another one.
pipeline::solve::PlayerError player_of(const pipeline::Shot& shot, int event) {
    if (shot.solved.empty()) {
        return *pipeline::solve::player_error("club");
    }
    const auto own = std::ranges::find(shot.solved, static_cast<std::size_t>(event),
                                       &pipeline::SolvedStrike::event);
    return (own != shot.solved.end() ? *own : shot.solved.front()).question->problem.player;
}

}  // namespace

SoughtStrike sought_strike(const pipeline::Shot& shot, const sim::Timeline& timeline, int event,
                           const std::string& struck) {
    SoughtStrike sought{shot.world, static_cast<std::size_t>(std::max(event, 0)), 0,
                        player_of(shot, event)};
    std::vector<sim::ForceEvent>& events = sought.world.events;
    if (event == static_cast<int>(events.size()) && is_ball(shot.world, struck)) {
        double time = kNewStrike;
        for (const sim::ForceEvent& each : events) {
            time = std::max(time, each.time + each.after + kNewStrike);
        }
        sim::Strike strike;
        strike.direction = 0;
        strike.speed = 2;
        events.push_back({struck, time, std::nullopt, 0, strike});
        sought.time = time;
        return sought;
    }
    if (event < 0 || event >= static_cast<int>(events.size()) ||
        !std::holds_alternative<sim::Strike>(events[sought.event].action)) {
        throw Error("the shot has no such strike any more");
    }
    const ShotEvent told = event_messages(shot, timeline)[sought.event];
    auto& strike = std::get<sim::Strike>(events[sought.event].action);
    strike.direction = told.direction;
    strike.toward.reset();
    strike.toward_point.reset();
    sought.time = told.time;
    sought.world = pipeline::solve::without_later_strikes(std::move(sought.world), sought.event);
    return sought;
}

std::vector<Pot> pots_of(const SoughtStrike& sought, const sim::Timeline& timeline) {
    const double end = next_strike(timeline, sought.time);
    std::vector<Pot> pots;
    for (const sim::Event& event : timeline.events) {
        if (event.kind == sim::EventKind::potted && event.time > sought.time && event.time < end &&
            event.a != sought.ball()) {
            pots.push_back({event.a, event.b});
        }
    }
    return pots;
}

std::string first_hit(const SoughtStrike& sought, const sim::Timeline& timeline) {
    const double end = next_strike(timeline, sought.time);
    for (const sim::Event& event : timeline.events) {
        if (event.kind != sim::EventKind::impact || event.time < sought.time || event.time >= end) {
            continue;
        }
        if (event.a == sought.ball() && is_ball(sought.world, event.b)) {
            return event.b;
        }
        if (event.b == sought.ball() && is_ball(sought.world, event.a)) {
            return event.a;
        }
    }
    return {};
}

pipeline::solve::SolveProblem pot_problem(const SoughtStrike& sought,
                                          const std::vector<Pot>& pots) {
    pipeline::solve::SolveProblem problem;
    problem.event = sought.event;
    problem.player = sought.player;
    problem.may_raise = sought.strike().elevation == 0;
    for (const Pot& pot : pots) {
        problem.wants.emplace_back(potted(pot));
    }
    pipeline::solve::Happening scratch = potted({sought.ball(), ""});
    scratch.at_least = scratch.at_most = 0;
    problem.wants.emplace_back(scratch);
    return problem;
}

}  // namespace carom::studio
