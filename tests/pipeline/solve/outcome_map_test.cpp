#include "pipeline/solve/outcome_map.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/pipeline/solve/solve_layouts.h"

namespace carom::pipeline::solve {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// A cut that is potted, and that the cue ball comes to rest near where it does.
struct Found {
    Layout layout = make_layouts()[20];
    sim::Trials trials{layout.world};
    Solution best = solve(trials, layout.problem).solutions.front();

    Found() { layout.problem.wants.emplace_back(RestPlace{"cue", *best.rest, 0.15}); }
    [[nodiscard]] MapRange range() const {
        MapRange range = range_around(best.strike, best.window_width());
        range.columns = 25;
        range.rows = 9;  // that of the strike in the middle
        range.high_speed = 1.5 * *best.strike.speed;
        return range;
    }
};

TEST(OutcomeMapTest, ShowsTheWindowAndThePlace) {
    const Found found;
    const OutcomeMap map =
        outcome_map(found.trials, found.layout.problem, found.best.strike, found.range());
    ASSERT_EQ(map.cells.size(), 225U);
    ASSERT_EQ(map.rests.size(), 225U);
    const double direction = *found.best.strike.direction;
    for (std::size_t column = 0; column < map.directions.size(); ++column) {
        const double off = std::abs(map.directions[column] - direction);
        const MapCell cell = map.at(4, column);
        EXPECT_EQ(cell == MapCell::wanted || cell == MapCell::misplaced,
                  off < 0.5 * found.best.window_width())
            << off / kDegree << " degrees off, window " << found.best.window_width() / kDegree;
    }
    for (std::size_t i = 0; i < map.cells.size(); ++i) {
        if (map.cells[i] != MapCell::wanted && map.cells[i] != MapCell::misplaced) {
            continue;
        }
        const Vec2 off = map.rests[i].value() - *found.best.rest;
        EXPECT_EQ(map.cells[i] == MapCell::wanted, off.length() <= 0.15);
    }
    EXPECT_GT(std::ranges::count(map.cells, MapCell::wanted), 0);
    EXPECT_GT(std::ranges::count(map.cells, MapCell::misplaced), 0);
}

TEST(OutcomeMapTest, AvoidedHappening_IsToldFromNothing) {
    Found found;
    // The cue ball is potted where it is struck at a pocket.
    MapRange range;
    range.low_direction = 0;
    range.high_direction = 360 * kDegree;
    range.low_speed = 2;
    range.high_speed = 3;
    range.columns = 180;
    range.rows = 1;
    const OutcomeMap map =
        outcome_map(found.trials, found.layout.problem, found.best.strike, range);
    EXPECT_GT(std::ranges::count(map.cells, MapCell::avoided), 0);
    EXPECT_GT(std::ranges::count(map.cells, MapCell::nothing), 90);
}

TEST(OutcomeMapTest, SameWithAnyNumberOfThreads_AndCanBeStopped) {
    const Found found;
    const SolveProblem& problem = found.layout.problem;
    const OutcomeMap one =
        outcome_map(found.trials, problem, found.best.strike, found.range(), {1, {}});
    const OutcomeMap three =
        outcome_map(found.trials, problem, found.best.strike, found.range(), {3, {}});
    EXPECT_EQ(one.cells, three.cells);
    EXPECT_EQ(one.rests, three.rests);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW((void)outcome_map(found.trials, problem, found.best.strike, found.range(),
                                   {1, {{}, stop.get_token()}}),
                 Stopped);
}

TEST(LandingsTest, ChanceOfTheSolutionIsTheirShare) {
    Found found;
    found.layout.problem.wants.pop_back();
    const std::vector<Landing> all =
        landings(found.trials, found.layout.problem, found.best.strike, 100);
    EXPECT_NEAR(found.best.chance,
                static_cast<double>(std::ranges::count(all, MapCell::wanted, &Landing::cell)) / 100,
                1e-12);
    EXPECT_TRUE(std::ranges::all_of(
        all, [](const Landing& each) { return each.cell == MapCell::avoided || each.rest; }));
}

}  // namespace
}  // namespace carom::pipeline::solve
