// The computed sound of a film as a source of samples.
#pragma once

#include <functional>
#include <stop_token>

#include "pipeline/job/film_job.h"
#include "pipeline/job/film_sound.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"
#include "sound/sound_scene.h"

namespace carom::pipeline {

/// Makes the sound that the scene describes when it is first needed. `scene` may be called several
/// times; what the scenes refer to must outlive the sounds. Throws Stopped while it makes or gives
/// samples.
[[nodiscard]] SoundMaker computed_sound(std::function<sound::SoundScene()> scene,
                                        std::stop_token stop);

/// The sound of a shot's whole film; empty if the shot wants none. Refers to both arguments;
/// `timeline` as in film_scene (pipeline/sound/film_scene.h).
[[nodiscard]] SoundMaker shot_sound(const Shot& shot, const sim::Timeline& timeline,
                                    std::stop_token stop);

/// The sound that a job's options ask for, else the shot's own.
[[nodiscard]] SoundMaker job_sound(const FilmJobOptions& options, const Shot& shot,
                                   const sim::Timeline& timeline, std::stop_token stop);

}  // namespace carom::pipeline
