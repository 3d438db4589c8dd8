#include "pipeline/solve/explain.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "core/text.h"
#include "sim/aim/find_aims.h"

namespace carom::pipeline::solve {
namespace {

/// Why the wanted balls cannot be potted directly, one sentence each.
std::string why_not_directly(const sim::WorldDescription& world, const SolveProblem& problem) {
    std::string text;
    for (const Want& want : problem.wants) {
        const auto* happening = std::get_if<Happening>(&want);
        if (happening == nullptr || happening->is_avoided() ||
            happening->trigger.kind != sim::Trigger::Kind::potted) {
            continue;
        }
        const sim::FoundAims direct = sim::find_aims(
            world, {{problem.event, sim::PotAim{happening->trigger.a, happening->pocket}}});
        for (const Diagnostic& reason : direct.problems) {
            text += "; directly: " + reason.sentence;
        }
    }
    return text;
}

/// Calls use(the whole trial of that strike).
template <class Use>
void with_trial(const sim::WorldDescription& world, const SolveProblem& problem,
                const sim::Strike& sought, const Use& use) {
    const sim::Trials trials(world);
    const std::vector<sim::ForceEvent>& given = world.events;
    std::vector<sim::ForceEvent> events = given;
    events[problem.event].action = sought;
    sim::TrialLimits limits;
    limits.keeps_motion = true;
    const std::optional<sim::Outcome> outcome = trials.run(std::move(events), limits);
    const auto strike = static_cast<std::size_t>(std::count_if(
        given.begin(), given.begin() + static_cast<std::ptrdiff_t>(problem.event),
        [](const sim::ForceEvent& e) { return std::holds_alternative<sim::Strike>(e.action); }));
    use(Trial{trials.world(), trials.names(), outcome.value(), strike});
}

/// What is not as it is wanted, but for happenings.
std::vector<std::string> lacks_of(const SolveProblem& problem, const Trial& trial) {
    std::vector<std::string> lacks;
    for (const Want& want : problem.wants) {
        if (miss_of(want, trial) == 0) {
            continue;
        }
        if (const auto* rest = std::get_if<RestPlace>(&want)) {
            const std::optional<Vec2> place = trial.place_of(rest->ball);
            lacks.push_back(place ? fmt::format("'{}' rests at [{:.2f}, {:.2f}], {:.2f} m away",
                                                rest->ball, place->x, place->y,
                                                (*place - rest->near).length())
                                  : fmt::format("'{}' is not on the table", rest->ball));
        } else if (const auto* measured = std::get_if<MeasuredRange>(&want)) {
            const std::optional<double> value = measured->value(trial);
            lacks.push_back(value ? fmt::format("'{}' is {:.4g}", measured->title, *value)
                                  : fmt::format("'{}' does not happen", measured->title));
        } else if (const auto* clearing = std::get_if<Clearing>(&want)) {
            lacks.push_back(
                fmt::format("'{}' does not fly over '{}'", clearing->ball, clearing->blocker));
        }
    }
    return lacks;
}

}  // namespace

std::vector<std::pair<std::string, std::optional<double>>> measured_values(
    const sim::WorldDescription& world, const SolveProblem& problem, const sim::Strike& strike) {
    std::vector<std::pair<std::string, std::optional<double>>> values;
    const auto is_measured = [](const Want& want) {
        return std::holds_alternative<MeasuredRange>(want);
    };
    if (std::ranges::any_of(problem.wants, is_measured)) {
        with_trial(world, problem, strike, [&](const Trial& trial) {
            for (const Want& want : problem.wants) {
                if (const auto* measured = std::get_if<MeasuredRange>(&want)) {
                    values.emplace_back(measured->title, measured->value(trial));
                }
            }
        });
    }
    return values;
}

std::string why_unsolved(const sim::WorldDescription& world, const SolveProblem& problem,
                         const SolveResult& result) {
    std::string text = fmt::format("no strike was found that does all this, in {} simulations",
                                   result.simulations);
    if (!result.solutions.empty()) {
        const Solution& nearest = result.solutions.front();
        if (nearest.miss < 10) {
            with_trial(world, problem, nearest.strike, [&](const Trial& trial) {
                text += fmt::format("; the nearest, {}: {}", nearest.route,
                                    join(lacks_of(problem, trial), "; "));
            });
        } else {
            text += "; the nearest does only: " + nearest.route;
        }
    }
    return text + why_not_directly(world, problem);
}

}  // namespace carom::pipeline::solve
