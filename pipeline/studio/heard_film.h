// What the studio's film sounds like: of a shot, and of a film of several shots.
#pragma once

#include <memory>
#include <string>

#include "pipeline/shot/shot.h"
#include "pipeline/studio/live_shot.h"
#include "sim/timeline/timeline.h"
#include "sound/sound_scene.h"

namespace carom::studio {

/// A film as it is heard.
struct HeardFilm {
    std::string reason{};  // a sentence why it has no sound; empty: it has one
    sound::SoundScene scene{};
};

/// The film of a shot. The scene refers to both arguments.
[[nodiscard]] HeardFilm heard_film(const pipeline::Shot& shot, const sim::Timeline& timeline);

/// A film of several shots. The scene refers to the argument.
[[nodiscard]] HeardFilm heard_film(const SequenceAnswer& film);

}  // namespace carom::studio
