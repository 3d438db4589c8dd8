// The clips of a film's sound: which camera hears which scene time, and from where.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "pipeline/camera/camera_rig.h"
#include "pipeline/shot/sound_settings.h"
#include "sim/timeline/timeline.h"
#include "sound/sound_scene.h"

namespace carom::pipeline {

/// A part of a shot's own film, and where another film shows it. Times are s.
struct ShownPart {
    double from = 0;  // video time of the shot's own film
    double to = 0;
    double start = 0;     // time of the film at which it begins
    double fade_in = 0;   // over which its sound rises, by equal power
    double fade_out = 0;  // over which it falls, before `to`
    double film_end = std::numeric_limits<double>::infinity();  // of the other film
};

/// The clips of the part, in order. During a fade between two cameras both are heard by equal
/// power. Clips outside of the other film, [0, film_end), are left out. The functions of the
/// clips refer to the rigs and the timeline. `aspect`: width / height of the picture.
[[nodiscard]] std::vector<sound::Clip> clips_of(std::span<const CameraRig> rigs,
                                                const sim::Timeline& timeline,
                                                const SoundSettings& settings, double aspect,
                                                const ShownPart& part);

}  // namespace carom::pipeline
