#include "pipeline/studio/strike_judge.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <vector>

#include "core/cpu_time.h"
#include "core/error.h"
#include "pipeline/solve/outcome_map.h"
#include "pipeline/solve/solver.h"

namespace carom::studio {

namespace {

namespace solve = pipeline::solve;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSlowTrial = 0.05;  // s; a shot with slower ones is not judged after each edit
constexpr double kSlowest = 0.5;     // m/s, of the map
constexpr double kFastest = 8;

double seconds_of_trial(const JudgedStrike& job, const std::stop_token& stop) {
    const double start = thread_cpu_seconds();
    sim::TrialLimits limits;
    limits.stop = stop;
    static_cast<void>(job.trials->run(job.sought.world.events, limits));
    return thread_cpu_seconds() - start;
}

void judge(const JudgedStrike& job, const pipeline::PartsWork& work, Judged& judged) {
    judged.direction = *job.sought.strike().direction;
    const std::vector<Pot> pots = pots_of(job.sought, job.timeline);
    if (pots.empty()) {
        return;
    }
    const solve::Solution found =
        solve::Solver(job.trials, pot_problem(job.sought, pots)).judge(job.sought.strike(), work);
    if (found.is_solved) {
        judged.pots = pots;
        judged.window = {found.window.x, found.window.y};
        judged.chance = found.chance;
        judged.chance_error = found.chance_error;
    }
}

/// The directions of the map: those of the question, else around the strike.
std::array<double, 2> directions_of(const Judge& question, const Judged& judged) {
    if (question.directions && (*question.directions)[0] < (*question.directions)[1]) {
        return *question.directions;
    }
    const double half =
        judged.pots.empty()
            ? 5 * kDegree
            : std::clamp(2.5 * (judged.window[1] - judged.window[0]), kDegree, 6 * kDegree);
    return {judged.direction - half, judged.direction + half};
}

/// What counts as success in the map: what the strike pots, else the ball that it hits first.
std::vector<Pot> pots_of_map(const JudgedStrike& job, const Judged& judged) {
    if (!judged.pots.empty()) {
        return judged.pots;
    }
    const std::string ball = first_hit(job.sought, job.timeline);
    return ball.empty() ? std::vector<Pot>() : std::vector<Pot>{{ball, ""}};
}

StrikeMap map_of(const JudgedStrike& job, const solve::SolveProblem& problem,
                 const solve::MapRange& range, const pipeline::PartsWork& work) {
    StrikeMap map;
    map.directions = {range.low_direction, range.high_direction};
    map.speeds = {range.low_speed, range.high_speed};
    map.columns = static_cast<int>(range.columns);
    map.rows = static_cast<int>(range.rows);
    for (const solve::MapCell cell :
         solve::outcome_map(*job.trials, problem, job.sought.strike(), range, work).cells) {
        map.cells += cell == solve::MapCell::nothing   ? 'n'
                     : cell == solve::MapCell::avoided ? 'a'
                                                       : 'w';
    }
    return map;
}

}  // namespace

void judge_strike(const JudgedStrike& job, const std::stop_token& stop,
                  const std::function<void(const ServerMessage&)>& tell) {
    pipeline::PartsWork work;
    work.context.stop = stop;
    Judged judged{job.question.q, job.v, job.question.event};
    bool is_quick = false;
    try {
        is_quick = seconds_of_trial(job, stop) < kSlowTrial;
        if (is_quick) {
            judge(job, work, judged);
        }
    } catch (const Stopped&) {
        tell(judged);  // nothing is known: a page asks no other question about the shot before
        throw;
    }
    tell(judged);
    const std::vector<Pot> pots = pots_of_map(job, judged);
    if (!job.question.wants_map || !is_quick || pots.empty()) {
        return;
    }
    const sim::Strike& strike = job.sought.strike();
    const double speed = strike.ball_speed.value_or(strike.speed.value_or(0));
    const auto [low, high] = directions_of(job.question, judged);
    solve::MapRange range{low, high, kSlowest, std::max(kFastest, 1.25 * speed)};
    const solve::SolveProblem problem = pot_problem(job.sought, pots);
    for (const std::size_t rows : {16U, 32U}) {
        range.columns = 3 * rows;
        range.rows = rows;
        StrikeMap map = map_of(job, problem, range, work);
        map.q = job.question.q;
        map.v = job.v;
        map.event = job.question.event;
        map.pots = pots;
        tell(map);
    }
}

}  // namespace carom::studio
