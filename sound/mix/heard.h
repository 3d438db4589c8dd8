// The list of what is heard in a film, for tables and reports.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "sim/timeline/event.h"
#include "sound/sound_scene.h"

namespace carom::sound {

/// An impact as a listener hears it once. Pressure and level are those of the direct sound
/// (with the mirror image in the bed) at the centre of the head, before any gain.
struct HeardImpact {
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
    double delay = 0;         // s, of that way; 0 if the camera's sound has no delay
    double impulse = 0;       // N s
    double contact_time = 0;  // s, in the scene
    double peak = 0;          // Pa, highest absolute pressure
    double gain = 0;          // dB: of the dynamics, the camera, its mix and a fade together
};

/// Calls `sink` for every impact that the mix contains, in order of film time and, at the same
/// time, of the event log. Throws Stopped.
void list_heard(const SoundScene& scene, const std::function<void(const HeardImpact&)>& sink,
                const WorkContext& context = {});

/// The same as a list.
[[nodiscard]] std::vector<HeardImpact> heard(const SoundScene& scene,
                                             const WorkContext& context = {});

}  // namespace carom::sound
