// What a camera may say about its sound.
#pragma once

#include <array>
#include <optional>

#include "core/vectors.h"
#include "sound/sound_scene.h"

namespace carom::pipeline {

/// Where the film is heard from: with its camera, or from one place.
struct ListenerPlace {
    bool is_camera = true;
    Vec3 at{0, -1.5, 1.2};    // m
    Vec3 facing{0, 1, -0.4};  // not vertical
};

/// Values that are empty are those of the whole film.
struct CameraSound {
    std::optional<double> gain;    // dB; minus infinity: the camera has no sound
    std::optional<double> pitch;   // exponent of the speed: 1 follows it, 0 keeps the pitch
    std::optional<double> lowest;  // the pitch goes no lower than at this speed, > 0
    std::optional<bool> mirrors_reverse;
    std::optional<bool> has_delay;
    std::optional<sound::Stereo> stereo;
    std::optional<sound::Width> width;
    std::optional<double> ratio;  // of the dynamics, >= 1
    std::optional<ListenerPlace> listener;
    std::array<std::optional<double>, sound::kGroupCount> mix{};  // dB, by sound::Group
};

}  // namespace carom::pipeline
