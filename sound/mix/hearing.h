// One impact as a camera of the film hears it: how loud, from where, how fast it plays.
#pragma once

#include <optional>
#include <vector>

#include "sound/mix/crossings.h"
#include "sound/mix/heard.h"
#include "sound/sound_scene.h"
#include "sound/source/arrival.h"
#include "sound/source/impact_sound.h"

namespace carom::sound {

struct Heard {
    HeardImpact row;
    ImpactSound sound;
    Arrival arrival;  // direct, at the head's centre
    Listener listener;
    PassageSettings settings;
    bool is_mirrored = false;  // it plays backwards
};

/// Looks at the crossings of one scene, which must outlive it and not change.
class Hearing {
  public:
    explicit Hearing(const SoundScene& scene);

    /// What is heard of it; empty if it has no sound, or a peak below 0 dB (20 uPa) at 1 m, or no
    /// weight in a fade. Its gain is that of the dynamics (dynamics_factor) for the peak at
    /// average_place(), so it depends on the impact alone, and not on where it is heard from; plus
    /// those of the camera and of its group, plus that of the fade at its instant.
    [[nodiscard]] std::optional<Heard> at(const Crossing& crossing) const;

    /// The longest that a sound rings after its force in the film, s: the time in which the mode
    /// with the least damping of the shot falls to a 4000th, at the shot's slowest playing speed
    /// among those passages that play it backwards; 0 if there are none.
    [[nodiscard]] double longest_mirrored_ring(std::size_t shot) const;

  private:
    const SoundScene& scene_;
    std::vector<ImpactSounds> sounds_;  // by shot
};

/// Whether a passage plays its sounds mirrored in time.
[[nodiscard]] bool is_mirrored(const Passage& passage);

}  // namespace carom::sound
