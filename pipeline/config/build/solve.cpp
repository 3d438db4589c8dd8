#include <algorithm>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "core/error.h"
#include "core/lru_cache.h"
#include "core/text.h"
#include "pipeline/config/build/builder.h"
#include "pipeline/config/measures/measures.h"
#include "pipeline/config/pocket_names.h"
#include "pipeline/solve/answers.h"
#include "pipeline/solve/explain.h"

namespace carom::pipeline::config {
namespace {

using solve::Happening;
using solve::Want;

/// Sets how a measure is read from a trial.
void complete(solve::MeasuredRange& measured, const Place& place, Builder& builder) {
    auto parsed = measures::parse_measure(measured.measure, builder.shot.world);
    if (const auto* wrong = std::get_if<measures::TextProblem>(&parsed)) {
        builder.reader.error(place, wrong->sentence);
        return;
    }
    auto& measure = std::get<measures::Measure>(parsed);
    measured.title = measure.title();
    measured.needs_motion = measure.needs_motion;
    measured.value = [of = std::move(measure.value)](const solve::Trial& trial) {
        const measures::Value value = of({trial.world, trial.names, trial.outcome});
        const auto* number = std::get_if<double>(&value);
        return number != nullptr ? std::optional(*number) : std::nullopt;
    };
}

/// The want with the pocket's own name, the struck ball and how a measure is read.
Want complete(const WantSection& section, Builder& builder, const std::string& struck) {
    Want want = section.want;
    const auto& table = builder.shot.world.table;
    if (auto* happening = std::get_if<Happening>(&want);
        happening != nullptr && !happening->pocket.empty() && table) {
        happening->pocket = pocket_of_name(*table, happening->pocket);
    } else if (auto* clearing = std::get_if<solve::Clearing>(&want); clearing != nullptr) {
        clearing->ball = struck;
    } else if (auto* measured = std::get_if<solve::MeasuredRange>(&want)) {
        complete(*measured, section.place, builder);
    }
    return want;
}

/// Whether the wants say something of a pot of the struck ball.
bool speaks_of_scratch(const SolveSection& section, const std::string& struck) {
    const auto speaks = [&](const WantSection& want) {
        const auto* happening = std::get_if<Happening>(&want.want);
        return happening != nullptr && happening->trigger.kind == sim::Trigger::Kind::potted &&
               happening->trigger.a == struck;
    };
    return std::ranges::any_of(section.wants, speaks) ||
           std::ranges::any_of(section.avoided, speaks);
}

solve::SolveProblem problem_of(const SolveSection& section, const OpenStrike& open,
                               Builder& builder) {
    const std::string& struck = builder.shot.world.events[open.event].object;
    solve::SolveProblem problem;
    problem.event = open.event;
    problem.finds_direction = open.finds_direction;
    problem.finds_speed = open.finds_speed;
    problem.finds_tip = open.finds_tip;
    problem.finds_elevation = open.finds_elevation;
    problem.may_raise = open.may_raise;
    problem.prefer = section.prefer;
    problem.player = section.player;
    for (const auto* list : {&section.wants, &section.avoided}) {
        for (const WantSection& want : *list) {
            problem.wants.push_back(complete(want, builder, struck));
        }
    }
    if (!speaks_of_scratch(section, struck)) {
        Happening scratch;
        scratch.trigger.kind = sim::Trigger::Kind::potted;
        scratch.trigger.a = struck;
        scratch.at_least = scratch.at_most = 0;
        problem.wants.emplace_back(scratch);
    }
    return problem;
}

/// True if the section names a strike that is there, and something of it is to be found.
bool names_strike(Builder& builder, const SolveSection& section, const OpenStrike& open) {
    const auto& events = builder.shot.world.events;
    if (open.event >= events.size() ||
        !std::holds_alternative<sim::Strike>(events[open.event].action)) {
        builder.reader.error(
            section.place, section.event
                               ? fmt::format("'strike: {}' names no strike of 'events', which are "
                                             "numbered from 0",
                                             *section.event)
                               : "there is no strike whose direction or speed is to be found");
        return false;
    }
    if (!open.finds_direction && !open.finds_speed && !open.finds_tip && !open.finds_elevation) {
        builder.reader.error(section.place,
                             "the strike gives its direction, speed and tip: nothing "
                             "is left to be found");
        return false;
    }
    return true;
}

/// Those of the last shots are kept: an edit of a camera does not solve the shot again.
std::shared_ptr<const solve::SolveResult> solution_of(const solve::SolveQuestion& question,
                                                      const solve::AnswerWork& work) {
    constexpr std::size_t kKept = 16;
    static LruCache<Hash128, solve::SolveResult> known(kKept);
    std::shared_ptr<const solve::SolveResult> incomplete;
    try {
        return known.get(hash_of(question), [&] {
            solve::SolveResult result = solve::answer(question, work);
            if (!result.is_complete) {
                incomplete = std::make_shared<const solve::SolveResult>(std::move(result));
                throw Stopped();
            }
            return result;
        });
    } catch (const Stopped&) {
        const bool has_any =
            incomplete && !incomplete->solutions.empty() && incomplete->solutions.front().is_solved;
        if (!work.takes_incomplete || !has_any) {
            throw;
        }
        return incomplete;
    }
}

FoundStrike texts_of(const OpenStrike& open, const sim::Strike& strike) {
    constexpr double kDegree = std::numbers::pi / 180;
    FoundStrike found;
    found.event = open.event;
    const auto add = [&](bool is_found, const char* key, std::string value) {
        if (is_found) {
            found.values.emplace_back(key, std::move(value));
        }
    };
    add(open.finds_direction, "direction",
        decimal_text(strike.direction.value_or(0) / kDegree, 6) + " deg");
    add(open.finds_speed, "speed", decimal_text(strike.speed.value_or(0), 4) + " m/s");
    add(open.finds_tip, "tip",
        fmt::format("[{}, {}]", decimal_text(strike.tip.x, 4), decimal_text(strike.tip.y, 4)));
    add(open.finds_elevation || (open.may_raise && strike.elevation > 0), "elevation",
        decimal_text(strike.elevation / kDegree, 6) + " deg");
    return found;
}

}  // namespace

namespace {

/// False after a problem.
bool solve_strike(Builder& builder, const SolveSection& section, const OpenStrike& open) {
    aim_strikes(builder, open.event);
    if (builder.reader.has_error() || !names_strike(builder, section, open)) {
        return false;
    }
    auto question = std::make_shared<const solve::SolveQuestion>(
        solve::SolveQuestion{solve::without_later_strikes(builder.shot.world, open.event),
                             problem_of(section, open, builder)});
    if (builder.reader.has_error()) {  // of a measure
        return false;
    }
    try {
        const std::shared_ptr<const solve::SolveResult> found = solution_of(
            *question, builder.answers != nullptr ? *builder.answers : solve::AnswerWork{});
        const solve::SolveResult& result = *found;
        if (result.solutions.empty() || !result.solutions.front().is_solved) {
            builder.reader.error(section.place,
                                 solve::why_unsolved(question->world, question->problem, result));
            return false;
        }
        const solve::Solution& best = result.solutions.front();
        builder.shot.world.events[open.event].action = best.strike;
        builder.found_strikes.push_back(texts_of(open, best.strike));
        builder.shot.solved.push_back(
            {open.event, std::move(question), found, builder.found_strikes.back().values});
        return true;
    } catch (const Stopped&) {
        throw;
    } catch (const Error& error) {  // the strike never comes
        builder.reader.error(section.place, error.what());
        return false;
    }
}

}  // namespace

void solve_strikes(Builder& builder) {
    for (std::size_t i = 0; i < builder.file.solve.size(); ++i) {
        if (!solve_strike(builder, builder.file.solve[i], builder.file.open.at(i))) {
            return;
        }
    }
    aim_strikes(builder);
}

}  // namespace carom::pipeline::config
