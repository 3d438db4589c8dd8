// When a film shows the events of its shots.
#pragma once

#include <compare>
#include <cstddef>
#include <vector>

#include "sound/sound_scene.h"

namespace carom::sound {

/// An impact or a strike as a clip shows it.
struct Onset {
    double film_time = 0;   // s
    std::size_t shot = 0;   // index in SoundScene::shots
    std::size_t event = 0;  // index in the shot's timeline's events
    std::size_t clip = 0;   // index in the shot's clips

    auto operator<=>(const Onset&) const = default;  // NOLINT(modernize-use-nullptr)
};

/// The impacts and strikes that a film shows, except contacts of things that settle (settling.h):
/// in order of film time, then of the shot, the place in the log and the clip. The film time is the
/// first in [clip.from, clip.to) at which the clip has reached the scene time, exact to 1e-12 s. A
/// clip that stands still shows nothing new. One that runs from scene time a to b shows [a, b),
/// backwards (b, a], so that of two clips that follow each other only one shows the instant between
/// them.
[[nodiscard]] std::vector<Onset> onsets_of(const SoundScene& scene);

}  // namespace carom::sound
