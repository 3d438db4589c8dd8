// How loud a film is, as a line over its time.
#pragma once

#include <vector>

#include "pipeline/plan/time_axis.h"
#include "pipeline/sound/film_levels.h"

namespace carom::pipeline {

inline constexpr double kQuietest = -80;  // dB of full scale, at the bottom

/// The levels over the axis of film time: those of full scale at `top`, those of kQuietest and
/// below at `bottom` (mm).
[[nodiscard]] std::vector<Vec2> loudness_curve(const FilmLevels& sound, const TimeAxis& axis,
                                               double top, double bottom);

/// The area between the curve and `bottom`.
[[nodiscard]] std::vector<Vec2> area_below(std::vector<Vec2> curve, double bottom);

}  // namespace carom::pipeline
