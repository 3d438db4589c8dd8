// Strikes are found for layouts with known answers. CAROM_ALL_LAYOUTS tries all of them; without
// it, every seventh.
#include <algorithm>
#include <cstdlib>
#include <ctime>

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
                   is_solved ? result.solutions.front().window * 57.29578 : 0,
                   is_solved ? result.solutions.front().chance : 0, result.simulations, seconds);
    }
    EXPECT_GE(solved, tried - (tries_all() ? 3 : 0));
}

TEST(SolveTest, AnswerIsTheSameWithAnyNumberOfThreads) {
    const Layout layout = make_layouts()[20];
    const sim::Trials trials(layout.world);
    const SolveResult one = solve(trials, layout.problem, {1, {}});
    const SolveResult three = solve(trials, layout.problem, {3, {}});
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

TEST(SolveTest, StopEndsIt) {
    const Layout layout = make_layouts()[20];
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(
        (void)solve(sim::Trials(layout.world), layout.problem, {1, {{}, stop.get_token()}}),
        Stopped);
}

}  // namespace
}  // namespace carom::pipeline::solve
