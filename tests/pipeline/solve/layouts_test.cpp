// Strikes are found for layouts with known answers. CAROM_ALL_LAYOUTS tries all of them; without
// it, every seventh.
#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <stop_token>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "sim/bake.h"
#include "tests/pipeline/solve/solve_layouts.h"

namespace carom::pipeline::solve {
namespace {

bool tries_all() {
    return std::getenv("CAROM_ALL_LAYOUTS") != nullptr;
}

double cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The strike meets all wants in a bake of the shot as it would be written.
void expect_verified(const Layout& layout, const Solution& solution) {
    sim::WorldDescription world = layout.world;
    world.events[layout.problem.event].action = solution.strike;
    const sim::Timeline timeline = sim::bake(world);
    EXPECT_EQ(timeline.events, solution.outcome.events) << layout.name;
    std::vector<std::string> names;
    for (const sim::Body& body : world.bodies) {
        names.push_back(body.name);
    }
    for (const Want& want : layout.problem.wants) {
        EXPECT_EQ(miss_of(want, {world, names, solution.outcome, 0}), 0) << layout.name;
    }
}

TEST(SolveLayoutsTest, StrikesAreFound) {
    const std::vector<Layout> layouts = make_layouts();
    std::size_t tried = 0;
    std::size_t solved = 0;
    for (std::size_t i = 0; i < layouts.size(); i += tries_all() ? 1 : 7) {
        const Layout& layout = layouts[i];
        const sim::Trials trials(layout.world);
        const double start = cpu_seconds();
        const SolveResult result = solve(trials, layout.problem, {});
        const double seconds = cpu_seconds() - start;
        const bool is_solved = !result.solutions.empty() && result.solutions.front().is_solved;
        ++tried;
        solved += is_solved ? 1 : 0;
        if (is_solved) {
            const Solution& best = result.solutions.front();
            expect_verified(layout, best);
            EXPECT_EQ(std::ranges::count_if(
                          result.solutions,
                          [&](const Solution& each) { return each.route == best.route; }),
                      1)
                << layout.name;
        }
        fmt::print("| {} | {} | {} | {:.2f} | {:.2f} | {} | {:.1f} |\n", layout.name,
                   is_solved ? result.solutions.front().route : "-",
                   std::ranges::count_if(result.solutions, &Solution::is_solved),
                   is_solved ? result.solutions.front().window_width() * 57.29578 : 0,
                   is_solved ? result.solutions.front().chance : 0, result.simulations, seconds);
    }
    EXPECT_GE(solved, tried - (tries_all() ? 3 : 0));
}

TEST(SolveTest, AnswerIsTheSameWithAnyNumberOfThreads) {
    const Layout layout = make_layouts()[20];
    const sim::Trials trials(layout.world);
    const SolveResult one = solve(trials, layout.problem, {{1, {}}});
    const SolveResult three = solve(trials, layout.problem, {{3, {}}});
    EXPECT_EQ(one.simulations, three.simulations);
    ASSERT_EQ(one.solutions.size(), three.solutions.size());
    for (std::size_t i = 0; i < one.solutions.size(); ++i) {
        EXPECT_EQ(one.solutions[i].strike.direction, three.solutions[i].strike.direction);
        EXPECT_EQ(one.solutions[i].chance, three.solutions[i].chance);
        EXPECT_EQ(one.solutions[i].outcome.events, three.solutions[i].outcome.events);
    }
}

TEST(SolveTest, GivenValuesStay) {
    Layout layout = make_layouts()[20];
    layout.problem.finds_speed = layout.problem.finds_tip = false;
    auto& strike = std::get<sim::Strike>(layout.world.events[0].action);
    strike.speed = 3.1;
    strike.tip = Vec2(0.2, 0.1);
    const SolveResult result = solve(sim::Trials(layout.world), layout.problem, {});
    ASSERT_FALSE(result.solutions.empty());
    for (const Solution& each : result.solutions) {
        EXPECT_EQ(each.strike.speed, 3.1);
        EXPECT_EQ(each.strike.tip, Vec2(0.2, 0.1));
    }
    EXPECT_TRUE(result.solutions.front().is_solved);
}

TEST(SolveTest, ImpossiblePlace_IsMissedByWhatIsSaid) {
    Layout layout = make_layouts()[20];
    layout.problem.wants.emplace_back(RestPlace{"cue", {5, 5}, 0.1});
    const SolveResult result = solve(sim::Trials(layout.world), layout.problem, {});
    ASSERT_FALSE(result.solutions.empty());
    EXPECT_FALSE(result.solutions.front().is_solved);
    EXPECT_GT(result.solutions.front().miss, 4);
    EXPECT_TRUE(std::ranges::is_sorted(result.solutions, {}, &Solution::miss));
}

TEST(SolveTest, StopKeepsWhatWasFound) {
    const Layout layout = make_layouts()[20];
    const sim::Trials trials(layout.world);
    std::stop_source stop;
    stop.request_stop();
    const SolveResult nothing = solve(trials, layout.problem, {{1, {{}, stop.get_token()}}, {}});
    EXPECT_FALSE(nothing.is_complete);
    EXPECT_TRUE(nothing.solutions.empty());

    std::stop_source later;
    const SolveResult some =
        solve(trials, layout.problem,
              {{1, {{}, later.get_token()}}, [&](const Solution&) { later.request_stop(); }});
    EXPECT_FALSE(some.is_complete);
    ASSERT_FALSE(some.solutions.empty());
    EXPECT_TRUE(some.solutions.front().is_solved);
}

/// The values of results that do not depend on what had been played before.
std::vector<std::pair<double, double>> answers(const SolveResult& result) {
    std::vector<std::pair<double, double>> values;
    for (const Solution& each : result.solutions) {
        values.emplace_back(each.strike.direction.value(), each.chance);
    }
    return values;
}

TEST(SolverTest, PlacesAskedAnew_GetTheAnswersOfANewSolver) {
    Layout layout = make_layouts()[20];
    layout.problem.max_routes = 2;
    const auto trials = std::make_shared<const sim::Trials>(layout.world);
    const RestPlace first{"cue", {0.3, 0.1}, 0.2};
    const RestPlace second{"cue", {-0.3, -0.1}, 0.2};
    layout.problem.wants.emplace_back(first);
    Solver solver(trials, layout.problem);
    std::stop_source stop;
    std::size_t told = 0;
    EXPECT_FALSE(solver
                     .solve({{1, {{}, stop.get_token()}},
                             [&](const Solution& each) {
                                 EXPECT_TRUE(each.is_solved);
                                 ++told;
                                 stop.request_stop();
                             }})
                     .is_complete);
    EXPECT_GT(told, 0U);
    const SolveResult again = solver.solve();
    EXPECT_EQ(answers(again), answers(solve(*trials, layout.problem)));

    solver.want_places({second});
    const SolveResult other = solver.solve();
    layout.problem.wants.back() = second;
    const SolveResult fresh = solve(*trials, layout.problem);
    EXPECT_EQ(answers(other), answers(fresh));
    EXPECT_LT(2 * other.simulations, fresh.simulations);
}

TEST(SolverTest, StrikeIsJudgedAsItIs) {
    const Layout layout = make_layouts()[20];
    Solver solver(std::make_shared<const sim::Trials>(layout.world), layout.problem);
    const SolveResult result = solver.solve();
    ASSERT_FALSE(result.solutions.empty());
    const Solution& best = result.solutions.front();
    sim::Strike aside = best.strike;
    aside.direction = *aside.direction + 0.3 * best.window_width();
    const Solution judged = solver.judge(aside);
    EXPECT_EQ(judged.strike.direction, aside.direction);
    EXPECT_TRUE(judged.is_solved);
    EXPECT_EQ(judged.route, best.route);
    EXPECT_NEAR(judged.window_width(), best.window_width(), 0.1 * best.window_width());
    EXPECT_LE(judged.chance, best.chance);
    aside.direction = *aside.direction + best.window_width();
    EXPECT_FALSE(solver.judge(aside).is_solved);
}

}  // namespace
}  // namespace carom::pipeline::solve
