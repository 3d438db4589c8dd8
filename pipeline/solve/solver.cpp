#include "pipeline/solve/solver.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "pipeline/solve/route.h"
#include "pipeline/solve/settle.h"

namespace carom::pipeline::solve {

namespace {

SolveResult search(const StrikeTrials& strike) {
    constexpr std::size_t kFine = 3;  // of the simplest routes
    std::vector<std::vector<Seed>> routes = scan_routes(strike);
    if (routes.size() > strike.problem().max_routes) {
        routes.resize(strike.problem().max_routes);
    }
    SolveResult result;
    result.solutions.resize(routes.size());
    do_parts(
        routes.size(),
        [&](std::size_t i) { result.solutions[i] = settle(strike, routes[i], i < kFine); },
        strike.work());
    result.simulations = strike.simulations();
    return result;
}

/// The best first, and one of each route.
void sort(std::vector<Solution>& solutions) {
    // A simple shot is taken before one that is hardly more likely.
    constexpr double kPerStep = 0.05;
    std::ranges::stable_sort(solutions, {}, [](const Solution& solution) {
        const auto steps = static_cast<double>(std::ranges::count(solution.route, ','));
        return std::pair(solution.miss, kPerStep * steps - solution.chance);
    });
    std::set<std::string> known;
    std::erase_if(solutions,
                  [&](const Solution& each) { return !known.insert(each.route).second; });
}

/// What was found from the moment of the strike on, in the whole shot.
void verify(const StrikeTrials& strike, Solution& solution) {
    solution.outcome = strike.play(setting_of(solution.strike), StrikeTrials::Depth::whole);
    solution.miss = strike.miss(solution.outcome);
    solution.is_solved = solution.miss == 0;
    const Trial trial = strike.trial_of(solution.outcome);
    solution.rest = trial.place_of(solution.ball);
    solution.route = route_of(strike.problem().wants, trial).text();
}

}  // namespace

SolveResult solve(const sim::Trials& trials, const SolveProblem& problem, const PartsWork& work) {
    const StrikeTrials strike(trials, problem, work);
    const std::optional<sim::WorldDescription> later = strike.world_at_strike();
    SolveResult result;
    if (later) {
        const sim::Trials at_strike(*later);
        SolveProblem own = problem;
        own.event = 0;
        result = search(StrikeTrials(at_strike, own, work));
        for (Solution& solution : result.solutions) {
            verify(strike, solution);
        }
    } else {
        result = search(strike);
    }
    sort(result.solutions);
    return result;
}

}  // namespace carom::pipeline::solve
