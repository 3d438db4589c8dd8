// A strike's values as a search varies them, and as a player misses them.
#pragma once

#include <cstdint>

#include "core/vectors.h"
#include "pipeline/solve/solver.h"
#include "sim/force_event.h"

namespace carom::pipeline::solve {

/// All of a strike that a search finds.
struct Setting {
    double direction = 0;  // rad
    double speed = 2;      // of the stick, m/s
    Vec2 tip{0, 0};        // ball radii
    double elevation = 0;  // rad
};

/// The setting with errors of normal distribution; `number` tells which. The tip stays where a
/// chalked one holds, the speed above 0, the elevation in [0, 85 deg].
[[nodiscard]] Setting disturbed(const Setting& setting, const PlayerError& error,
                                std::uint64_t number);

/// The setting in numbers that a text has exactly: millionths of a degree, the direction from 0 on,
/// ten thousandths of 1 m/s and of the ball's radius.
[[nodiscard]] Setting rounded(const Setting& setting);

/// The angle (rad) by which squirt turns the ball from the stick's direction.
[[nodiscard]] double squirt_of(const sim::Strike& strike, const Setting& setting, double radius);

[[nodiscard]] Setting setting_of(const sim::Strike& strike);

/// The strike with these values.
[[nodiscard]] sim::Strike with_setting(sim::Strike strike, const Setting& setting);

}  // namespace carom::pipeline::solve
