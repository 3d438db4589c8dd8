// What a film of several shots sounds like, as the sound library takes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include "pipeline/sequence/sequence.h"
#include "sim/timeline/timeline.h"
#include "sound/sound_scene.h"

namespace carom::pipeline {

/// The sound of `frames` frames of the film, from the frame `first` on. Refers to both arguments;
/// `timelines` by the index of the part, as of film_scene (pipeline/sound/film_scene.h). Sounds
/// fade with the pictures, by equal power; title cards are silent. The film has one gain: the full
/// scale or the loudness that the first part with one asks for.
[[nodiscard]] sound::SoundScene sequence_scene(
    const Sequence& sequence, const std::map<std::size_t, const sim::Timeline*>& timelines,
    std::int64_t first, std::int64_t frames);

}  // namespace carom::pipeline
