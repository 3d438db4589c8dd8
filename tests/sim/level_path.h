// An independent closed-form solution for one ball on a walled table, as reference for the
// simulation.
#pragma once

#include <functional>
#include <vector>

#include "core/vectors.h"

namespace carom::sim::test {

/// The state of a ball on the cloth, in the plane. `spin` is R w.
struct LevelState {
    Vec2 position{0, 0};
    Vec2 velocity{0, 0};
    Vec3 spin{0, 0, 0};
};

struct LevelTable {
    Vec2 half{1, 1};  // half extents of the area of the ball's centre
    double radius = 0.028575;
    double sliding_friction = 0.2;
    double rolling_friction = 0.01;
    double spinning_friction = 0.0127;
    double gravity = 9.81;
    /// The state after an impact; the Vec2 is the unit normal into the playing field.
    std::function<LevelState(const LevelState&, const Vec2&)> rebound;
};

/// The states of the ball after each `interval`, until it has travelled `length` metres or stops.
[[nodiscard]] std::vector<LevelState> level_path(const LevelTable& table, LevelState state,
                                                 double interval, double length);

/// The state of the ball when it has come to rest; the walls of `table` do not stop it.
[[nodiscard]] LevelState level_end(const LevelTable& table, LevelState state);

}  // namespace carom::sim::test
