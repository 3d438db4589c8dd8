#include "pipeline/solve/question.h"

#include <cstdint>
#include <variant>

#include "sim/bake.h"

namespace carom::pipeline::solve {
namespace {

Hasher& add(Hasher& hasher, const sim::Trigger& trigger) {
    return hasher.add(static_cast<int>(trigger.kind)).add(trigger.a).add(trigger.b);
}

void add(Hasher& hasher, const Want& want) {
    hasher.add(static_cast<std::uint64_t>(want.index()));
    if (const auto* happening = std::get_if<Happening>(&want)) {
        add(hasher, happening->trigger).add(happening->pocket);
        hasher.add(happening->skips_jaws);
        hasher.add(happening->at_least).add(happening->at_most).add(happening->by);
        hasher.add(happening->before.has_value());
        if (happening->before) {
            add(hasher, *happening->before);
        }
    } else if (const auto* rest = std::get_if<RestPlace>(&want)) {
        hasher.add(rest->ball).add(rest->near).add(rest->within);
    } else if (const auto* clearing = std::get_if<Clearing>(&want)) {
        hasher.add(clearing->ball).add(clearing->blocker);
    } else {
        const auto& measured = std::get<MeasuredRange>(want);
        hasher.add(measured.measure).add(measured.low).add(measured.high).add(measured.per_unit);
    }
}

}  // namespace

sim::WorldDescription without_later_strikes(sim::WorldDescription world, std::size_t event) {
    for (std::size_t i = world.events.size(); i-- > event + 1;) {
        if (std::holds_alternative<sim::Strike>(world.events[i].action)) {
            world.events.erase(world.events.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
    return world;
}

Hash128 hash_of(const SolveQuestion& question) {
    const SolveProblem& problem = question.problem;
    Hasher hasher;
    hasher.add(kSolverRevision)
        .add(sim::physics_hash(question.world))
        .add(static_cast<std::uint64_t>(problem.event));
    hasher.add(problem.finds_direction).add(problem.finds_speed);
    hasher.add(problem.finds_tip).add(problem.finds_elevation).add(problem.may_raise);
    hasher.add(static_cast<std::uint64_t>(problem.max_routes));
    hasher.add(static_cast<std::uint64_t>(problem.wants.size()));
    for (const Want& want : problem.wants) {
        add(hasher, want);
    }
    hasher.add(static_cast<std::uint64_t>(problem.prefer.size()));
    for (const Preference preference : problem.prefer) {
        hasher.add(static_cast<int>(preference));
    }
    const PlayerError& player = problem.player;
    hasher.add(player.direction).add(player.elevation).add(player.speed).add(player.tip);
    return hasher.finish();
}

}  // namespace carom::pipeline::solve
