// What is legal but surely not meant, seen from how a shot moves and is filmed.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/problem.h"
#include "pipeline/config/shot_source.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// What the simulation warned of, each at the key that it is about: "strike on 'cue' at 0.5 s: it
/// never touched 'one', which it was aimed at". Without a source: at no place.
[[nodiscard]] std::vector<Problem> simulation_problems(const sim::Timeline& timeline,
                                                       const ShotSource* source);

/// Balls that leave the part of an unbounded cloth that is drawn: a warning each. `source`: as
/// above.
[[nodiscard]] std::vector<Problem> cloth_problems(const Shot& shot, const ShotSource* source,
                                                  const sim::Timeline& timeline);

/// Cameras inside balls, and focused on what is behind them: warnings. A frame that makes no
/// picture is an error. Each once for a camera, with its first and last frame; of films of more
/// than 2000 frames as many are looked at, evenly. `source`: of the shot as it was read; nullptr if
/// its cameras are others.
[[nodiscard]] std::vector<Problem> camera_problems(const Shot& shot, const ShotSource* source,
                                                   const sim::Timeline& timeline);

}  // namespace carom::pipeline
