// Warnings about valid shots that are probably mistakes, found from the simulated motion and the
// cameras.
#pragma once

#include <string>
#include <vector>

#include "core/progress.h"
#include "pipeline/config/problem.h"
#include "pipeline/config/shot_source.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"
#include "sound/mix/added_sound.h"
#include "sound/sound_scene.h"

namespace carom::pipeline {

/// The warnings of the simulation, each at the key to which it refers: "strike on 'cue' at 0.5 s:
/// the ball never hit its target 'one'". Without a source they have no place.
[[nodiscard]] std::vector<Problem> simulation_problems(const sim::Timeline& timeline,
                                                       const ShotSource* source);

/// A warning for each ball that leaves the drawn part of an unbounded cloth. `source`: as above.
[[nodiscard]] std::vector<Problem> cloth_problems(const Shot& shot, const ShotSource* source,
                                                  const sim::Timeline& timeline);

/// Warnings about a cue stick that passes through the rail or a ball. `source`: as above.
[[nodiscard]] std::vector<Problem> stick_problems(const Shot& shot, const ShotSource* source,
                                                  const sim::Timeline& timeline);

/// A warning for each path that leaves the table, and for each annotation that needs a contact that
/// never happens. `source`: as above.
[[nodiscard]] std::vector<Problem> annotation_problems(const Shot& shot, const ShotSource* source,
                                                       const sim::Timeline& timeline);

/// Warnings about sound: of a ball that moves over a listener who stays in one place, and of
/// impacts that no camera shows although the listener is always there, so that one might expect to
/// hear them. `source`: as above.
[[nodiscard]] std::vector<Problem> sound_problems(const Shot& shot, const ShotSource* source,
                                                  const sim::Timeline& timeline);

/// A warning if the film does not reach the loudness that it asks for, or only if the limiter turns
/// its loudest sounds down by more than 12 dB, and one if its fixed gain is so high that they have
/// to be turned down. `music`: of the film; empty: none. Hears the whole film some six times, with
/// a fixed gain once. `source`: of the shot that asks, as above. Throws Stopped, and what the
/// music throws.
[[nodiscard]] std::vector<Problem> loudness_problems(const sound::SoundScene& film,
                                                     const ShotSource* source,
                                                     const sound::AddedSound& music = {},
                                                     const WorkContext& context = {});

/// Warnings about objects that are far too large or too small, so that their unit is probably
/// another one, about a picture on a mesh without uv, and about materials of a mesh file that its
/// object does not have. Files of more than 64 MB are not read. `source`: as above.
[[nodiscard]] std::vector<Problem> object_problems(const Shot& shot, const ShotSource* source);

/// Warnings about cameras that are inside an object (solid_check.h) or under the cloth, that show
/// nothing (things_check.h) or have their target far away, that are focused on an object behind
/// them, that do not show the object at which they aim or on which they are focused
/// (view_check.h), that turn too fast or film upside down (turn_check.h), or that look at the table
/// through a lamp (lamp_check.h), and errors for frames without a valid view. Each problem is
/// reported once per camera, with its first and last frame. In films of more than 2000 frames,
/// about 2000 evenly spaced ones are checked. `source`: of the shot as it was read; nullptr if it
/// has other cameras.
[[nodiscard]] std::vector<Problem> camera_problems(const Shot& shot, const ShotSource* source,
                                                   const sim::Timeline& timeline);

}  // namespace carom::pipeline
