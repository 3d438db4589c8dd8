// What a shot's film sounds like, as the sound library takes it.
#pragma once

#include <cstdint>

#include "pipeline/shot/shot.h"
#include "pipeline/sound/clips.h"
#include "sim/timeline/timeline.h"
#include "sound/sound_scene.h"

namespace carom::pipeline {

/// A part of the shot's film as a shot of a scene. A shot without sound has no clips. Refers to
/// both arguments; `timeline` has the tracks of moved objects (add_keyed_motions), and moments have
/// their times.
[[nodiscard]] sound::SoundShot sound_shot(const Shot& shot, const sim::Timeline& timeline,
                                          const ShownPart& part);

/// The sound of `frames` frames of the shot's film, from the frame `first` on.
[[nodiscard]] sound::SoundScene film_scene(const Shot& shot, const sim::Timeline& timeline,
                                           std::int64_t first, std::int64_t frames);

}  // namespace carom::pipeline
