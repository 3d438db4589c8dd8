// One ball on a walled table in closed form, written anew for the tests: what the simulation should
// find.
#pragma once

#include <functional>
#include <vector>

#include "core/vectors.h"

namespace carom::sim::test {

/// A ball on the cloth, in the plane. `spin` is R w.
struct LevelState {
    Vec2 position{0, 0};
    Vec2 velocity{0, 0};
    Vec3 spin{0, 0, 0};
};

struct LevelTable {
    Vec2 half{1, 1};  // the centre stays within
    double radius = 0.028575;
    double sliding_friction = 0.2;
    double rolling_friction = 0.01;
    double spinning_friction = 0.0127;
    double gravity = 9.81;
    /// Turns the state at the touch; the Vec2 is the unit normal into the field.
    std::function<LevelState(const LevelState&, const Vec2&)> rebound;
};

/// Where the ball is after each `interval`, until it has gone `length` metres or stops.
[[nodiscard]] std::vector<LevelState> level_path(const LevelTable& table, LevelState state,
                                                 double interval, double length);

/// The ball when it has come to rest; `table` has no walls in its way.
[[nodiscard]] LevelState level_end(const LevelTable& table, LevelState state);

}  // namespace carom::sim::test
