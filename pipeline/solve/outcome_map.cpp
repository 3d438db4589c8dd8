#include "pipeline/solve/outcome_map.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "pipeline/solve/player.h"
#include "pipeline/solve/strike_trials.h"

namespace carom::pipeline::solve {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

MapCell cell_of(const StrikeTrials& strike, const sim::Outcome& outcome) {
    const Trial trial = strike.trial_of(outcome);
    const auto is_missed = [&](const Want& want) { return miss_of(want, trial) > 0; };
    bool is_met = true;
    bool is_placed = true;
    for (const Want& want : strike.problem().wants) {
        const auto* happening = std::get_if<Happening>(&want);
        if (!is_missed(want)) {
            continue;
        }
        if (happening != nullptr && happening->at_least == 0) {
            return MapCell::avoided;
        }
        const bool is_place = is_of_end(want);
        is_met &= is_place;
        is_placed &= !is_place;
    }
    return !is_met ? MapCell::nothing : is_placed ? MapCell::wanted : MapCell::misplaced;
}

using Use = std::function<void(const StrikeTrials& strike, const sim::Trials& trials)>;

/// Calls `use` with trials from the moment of the strike on where that is possible, so that none
/// repeats what comes before.
void with_trials(const sim::Trials& trials, const SolveProblem& problem, const PartsWork& work,
                 const Use& use) {
    const StrikeTrials strike(trials, problem, work);
    if (const std::optional<sim::WorldDescription> later = strike.world_at_strike()) {
        const sim::Trials at_strike(*later);
        SolveProblem own = problem;
        own.event = 0;
        use(StrikeTrials(at_strike, own, work), at_strike);
    } else {
        use(strike, trials);
    }
}

/// The trial with that setting, to its end, also where nothing is as it is wanted.
sim::Outcome play(const StrikeTrials& strike, const sim::Trials& trials, const Setting& setting,
                  bool keeps_motion) {
    std::vector<sim::ForceEvent> events = trials.world().events;
    events[strike.problem().event].action = with_setting(strike.strike(), setting);
    sim::TrialLimits limits;
    limits.keeps_motion = keeps_motion;
    limits.stop = strike.work().context.stop;
    return trials.run(std::move(events), limits).value();
}

/// The `index`-th of `count` values from `low` to `high`, each in the middle of its part.
double middle_of(double low, double high, std::size_t index, std::size_t count) {
    return low + (high - low) * (static_cast<double>(index) + 0.5) / static_cast<double>(count);
}

}  // namespace

MapRange range_around(const sim::Strike& strike, double window) {
    const Setting setting = setting_of(strike);
    const double half = std::clamp(2 * window, 0.2 * kDegree, 6 * kDegree);
    MapRange range;
    range.low_direction = setting.direction - half;
    range.high_direction = setting.direction + half;
    range.low_speed = 0.5 * setting.speed;
    range.high_speed = 2 * setting.speed;
    return range;
}

OutcomeMap outcome_map(const sim::Trials& trials, const SolveProblem& problem,
                       const sim::Strike& around, const MapRange& range, const PartsWork& work) {
    OutcomeMap map;
    for (std::size_t i = 0; i < range.columns; ++i) {
        map.directions.push_back(
            middle_of(range.low_direction, range.high_direction, i, range.columns));
    }
    for (std::size_t i = 0; i < range.rows; ++i) {
        map.speeds.push_back(middle_of(range.low_speed, range.high_speed, i, range.rows));
    }
    map.cells.resize(range.rows * range.columns);
    map.rests.resize(map.cells.size());
    with_trials(trials, problem, work, [&](const StrikeTrials& strike, const sim::Trials&) {
        do_parts(
            map.cells.size(),
            [&](std::size_t i) {
                Setting setting = setting_of(around);
                setting.direction = map.directions[i % range.columns];
                setting.speed = map.speeds[i / range.columns];
                const sim::Outcome outcome = strike.play(setting, StrikeTrials::Depth::whole);
                map.cells[i] = cell_of(strike, outcome);
                if (map.cells[i] == MapCell::wanted || map.cells[i] == MapCell::misplaced) {
                    map.rests[i] = strike.trial_of(outcome).place_of(strike.ball());
                }
            },
            work);
    });
    return map;
}

std::vector<Landing> landings(const sim::Trials& trials, const SolveProblem& problem,
                              const sim::Strike& around, std::size_t count, const PartsWork& work) {
    std::vector<Landing> all(count);
    with_trials(trials, problem, work, [&](const StrikeTrials& strike, const sim::Trials& own) {
        const Setting setting = setting_of(around);
        do_parts(
            count,
            [&](std::size_t i) {
                const sim::Outcome outcome =
                    play(strike, own, disturbed(setting, problem.player, i), strike.needs_motion());
                all[i] = {cell_of(strike, outcome),
                          strike.trial_of(outcome).place_of(strike.ball())};
            },
            work);
    });
    return all;
}

sim::Timeline motion_of(const sim::Trials& trials, const SolveProblem& problem,
                        const sim::Strike& strike, const PartsWork& work) {
    sim::Timeline motion;
    with_trials(trials, problem, work, [&](const StrikeTrials& own, const sim::Trials& from) {
        motion = std::move(*play(own, from, setting_of(strike), true).motion);
    });
    return motion;
}

}  // namespace carom::pipeline::solve
