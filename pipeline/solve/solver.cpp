#include "pipeline/solve/solver.h"

#include <algorithm>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "core/error.h"
#include "pipeline/solve/route.h"
#include "pipeline/solve/settle.h"

namespace carom::pipeline::solve {

namespace {

/// The best first, and one of each route.
void sort(std::vector<Solution>& solutions) {
    std::ranges::stable_sort(solutions, {}, [](const Solution& solution) {
        return rank_of(solution.miss, solution.route, solution.chance);
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

struct Solver::Knowledge {
    bool has_begun = false;
    /// The world at the strike and its problem, if the strike is a later one (see
    /// StrikeTrials::world_at_strike).
    std::unique_ptr<const sim::Trials> at_strike;
    SolveProblem own;
    std::vector<Scan> scans;
    std::vector<KnownRoute> routes;  // after the scans
};

Solver::Solver(std::shared_ptr<const sim::Trials> trials, SolveProblem problem)
    : trials_(std::move(trials)),
      problem_(std::move(problem)),
      knowledge_(std::make_unique<Knowledge>()) {}

Solver::~Solver() = default;

void Solver::want_places(std::vector<RestPlace> places) {
    const auto replace = [&](std::vector<Want>& wants) {
        std::erase_if(wants,
                      [](const Want& want) { return std::holds_alternative<RestPlace>(want); });
        std::ranges::copy(places, std::back_inserter(wants));
    };
    replace(problem_.wants);
    replace(knowledge_->own.wants);
}

/// The trials of the strike: in the shot, and in the world at the strike where there is one.
struct Solver::Strikes {
    Strikes(Solver& solver, const PartsWork& work) : whole(*solver.trials_, solver.problem_, work) {
        Knowledge& known = *solver.knowledge_;
        if (!known.has_begun) {
            if (const auto later = whole.world_at_strike()) {
                known.at_strike = std::make_unique<const sim::Trials>(*later);
                known.own = solver.problem_;
                known.own.event = 0;
            }
            known.has_begun = true;
        }
        if (known.at_strike) {
            at_strike.emplace(*known.at_strike, known.own, work);
        }
    }

    /// In which strikes are sought.
    [[nodiscard]] const StrikeTrials& sought() const { return at_strike ? *at_strike : whole; }

    StrikeTrials whole;
    std::optional<StrikeTrials> at_strike;
};

/// Of level strikes, and if there are none, of those with a raised stick.
std::vector<std::vector<Seed>> Solver::find_seeds(const StrikeTrials& sought) {
    std::vector<Scan>& scans = knowledge_->scans;
    if (scans.empty()) {
        scans = make_scans(sought);
    }
    std::vector<std::vector<Seed>> seeds = scan_routes(sought, scans);
    if (seeds.empty() && problem_.may_raise) {
        problem_.may_raise = knowledge_->own.may_raise = false;
        problem_.finds_elevation = knowledge_->own.finds_elevation = true;
        scans = make_scans(sought);
        seeds = scan_routes(sought, scans);
    }
    return seeds;
}

SolveResult Solver::solve(const SolveWork& work) {
    constexpr std::size_t kFine = 3;  // of the simplest routes
    SolveResult result;
    std::vector<std::optional<Solution>> solutions;
    std::optional<Strikes> strikes;
    try {
        strikes.emplace(*this, work.parts);
        const StrikeTrials& sought = strikes->sought();
        std::vector<KnownRoute>& routes = knowledge_->routes;
        if (routes.empty()) {
            for (std::vector<Seed>& seeds : find_seeds(sought)) {
                if (routes.size() < problem_.max_routes) {
                    routes.push_back({std::move(seeds), routes.size() < kFine, {}, 0});
                }
            }
        }
        solutions.resize(routes.size());
        std::mutex mutex;
        const auto keep = [&](std::size_t i, Solution solution) {
            if (strikes->at_strike) {
                verify(strikes->whole, solution);
            }
            const std::lock_guard lock(mutex);
            if (work.found && (solution.is_solved || work.tells_nearest)) {
                work.found(solution);
            }
            solutions[i] = std::move(solution);
        };
        do_parts(
            routes.size(),
            [&](std::size_t i) {
                keep(i, settle(sought, routes[i], work.tells_nearest,
                               [&](const Solution& found) { keep(i, found); }));
            },
            work.parts);
    } catch (const Stopped&) {
        result.is_complete = false;
    }
    for (std::optional<Solution>& solution : solutions) {
        if (solution) {
            solution->outcome.motion.reset();  // of measures; large, and known from the strike
            result.solutions.push_back(std::move(*solution));
        }
    }
    if (strikes) {
        result.simulations = strikes->sought().simulations();
    }
    sort(result.solutions);
    return result;
}

Solution Solver::judge(const sim::Strike& strike, const PartsWork& work) {
    const Strikes strikes(*this, work);
    Solution solution = solve::judge(strikes.sought(), setting_of(strike));
    if (strikes.at_strike) {
        verify(strikes.whole, solution);
    }
    return solution;
}

SolveResult solve(const sim::Trials& trials, const SolveProblem& problem, const SolveWork& work) {
    return Solver({std::shared_ptr<void>(), &trials}, problem).solve(work);
}

}  // namespace carom::pipeline::solve
