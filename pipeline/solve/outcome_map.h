// What comes of strikes around one: over direction and speed, and under a player's errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/vectors.h"
#include "pipeline/solve/solver.h"
#include "pipeline/variants/variants.h"
#include "sim/force_event.h"
#include "sim/trials.h"

namespace carom::pipeline::solve {

/// What a trial brings about.
enum class MapCell : std::uint8_t {
    nothing,    // something that is wanted does not happen
    wanted,     // all is as it is wanted
    misplaced,  // all but where balls come to rest, or what a measure is
    avoided,    // something happens that is to be avoided, or too often
};

/// Over directions (columns) and speeds (rows), both ascending and evenly spaced.
struct OutcomeMap {
    using Cell = MapCell;
    std::vector<double> directions;          // rad
    std::vector<double> speeds;              // m/s, of the stick, or of the ball if the shot's is
    std::vector<Cell> cells;                 // row by row
    std::vector<std::optional<Vec2>> rests;  // likewise, of the struck ball, where the cell is
                                             // wanted or misplaced and the ball stays on the table

    [[nodiscard]] Cell at(std::size_t row, std::size_t column) const {
        return cells[row * directions.size() + column];
    }
};

/// What part of a map is shown, and how finely.
struct MapRange {
    double low_direction = 0, high_direction = 0;  // rad
    double low_speed = 0, high_speed = 0;          // m/s
    std::size_t columns = 120, rows = 60;
};

/// Four windows of directions (rad) wide, at least 0.4 and at most 12 degrees; from half the
/// strike's speed to twice as much.
[[nodiscard]] MapRange range_around(const sim::Strike& strike, double window);

/// The outcomes of the strike with other directions and speeds; all else is as in `around`. The
/// same with any number of threads. Throws as solve() does, and Stopped.
[[nodiscard]] OutcomeMap outcome_map(const sim::Trials& trials, const SolveProblem& problem,
                                     const sim::Strike& around, const MapRange& range,
                                     const PartsWork& work = {});

/// Where the struck ball comes to rest in a trial with a player's errors.
struct Landing {
    MapCell cell = MapCell::nothing;
    std::optional<Vec2> rest;  // empty: not on the table
};

/// Of trials with the errors of problem.player, the ones of which a solution's chance is the share.
[[nodiscard]] std::vector<Landing> landings(const sim::Trials& trials, const SolveProblem& problem,
                                            const sim::Strike& around, std::size_t count,
                                            const PartsWork& work = {});

/// How all moves with that strike, from its moment on where the search begins there.
[[nodiscard]] sim::Timeline motion_of(const sim::Trials& trials, const SolveProblem& problem,
                                      const sim::Strike& strike, const PartsWork& work = {});

}  // namespace carom::pipeline::solve
