// What the studio's film sounds like: of a shot, and of a film of several shots.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>

#include "pipeline/shot/shot.h"
#include "pipeline/studio/live_shot.h"
#include "pipeline/video/sound_source.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {

/// A film as it is heard, with its music.
struct HeardFilm {
    std::string reason{};      // a sentence why it has no sound; empty: it has one
    std::int64_t samples = 0;  // its length
    /// Makes the film's sound. Throws Error if the music cannot be read, and Stopped.
    std::function<std::unique_ptr<pipeline::SoundSource>(const std::stop_token& stop)> make{};
};

/// The film of a shot. The result refers to both arguments.
[[nodiscard]] HeardFilm heard_film(const pipeline::Shot& shot, const sim::Timeline& timeline);

/// A film of several shots. The result refers to the argument.
[[nodiscard]] HeardFilm heard_film(const SequenceAnswer& film);

}  // namespace carom::studio
