// What a film makes heard of its impacts: how loud, from where, how fast it plays.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "sim/timeline/event.h"
#include "sound/mix/onsets.h"
#include "sound/sound_scene.h"
#include "sound/source/direct_sound.h"
#include "sound/source/impact_sound.h"

namespace carom::sound {

/// An impact as a listener hears it once. Pressure and level are those of the direct sound
/// (with the mirror image in the bed) at the centre of the head, before any gain.
struct AudibleImpact {
    double film_time = 0;   // s, at which the film shows the impact
    double peak_time = 0;   // s, film time of the highest pressure, delay included
    double scene_time = 0;  // s
    std::size_t shot = 0;   // index in SoundScene::shots
    std::size_t event = 0;  // index in its timeline's events
    sim::EventKind kind = sim::EventKind::impact;
    Group group = Group::balls;
    std::string a;
    std::string b;  // empty for a strike
    std::string camera;
    double speed = 0;         // scene s per film s; negative backwards
    double time_factor = 1;   // of the sound
    double distance = 0;      // m, from the contact to the listener
    double delay = 0;         // s, over this distance; 0 if the camera's sound has no delay
    double impulse = 0;       // N s
    double contact_time = 0;  // s, in the scene
    double peak = 0;          // Pa, highest absolute pressure
    double gain = 0;          // dB: of the dynamics, the camera, its mix and a fade together
};

/// All that the mix needs of one.
struct AuralisedImpact {
    AudibleImpact row;
    ImpactSound sound;
    DirectSound direct;  // at the head's centre
    Listener listener;
    ClipSettings settings;
    bool is_mirrored = false;  // it plays backwards
};

/// Finds what is heard of the onsets of one scene, which must outlive it and not change.
class Auralisation {
  public:
    explicit Auralisation(const SoundScene& scene);

    /// What is heard of it; empty if it has no sound, or a peak below 0 dB (20 uPa) at 1 m, or no
    /// weight in a fade. Its gain is that of the dynamics (compressor_gain) for the peak at
    /// average_place(), so it depends on the impact alone, and not on where it is heard from; plus
    /// those of the camera and of its group, plus that of the fade at its instant.
    [[nodiscard]] std::optional<AuralisedImpact> at(const Onset& onset) const;

    /// The longest that a sound rings after its force in the film, s: the time in which the mode
    /// with the least damping of the shot falls to a 4000th, at the shot's slowest playing speed
    /// among those clips that play it backwards; 0 if there are none.
    [[nodiscard]] double longest_mirrored_ring(std::size_t shot) const;

  private:
    const SoundScene& scene_;
    std::vector<ImpactSounds> sounds_;  // by shot
};

/// Every impact that the mix contains, in order of film time and, at the same time, of the event
/// log. Throws Stopped.
[[nodiscard]] std::vector<AudibleImpact> audible_impacts(const SoundScene& scene,
                                                         const WorkContext& context = {});

}  // namespace carom::sound
