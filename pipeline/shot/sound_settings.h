// What a shot says about the sound of its film.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/camera/camera_sound.h"
#include "sound/sound_scene.h"

namespace carom::pipeline {

/// A physical material, or what balls touch ("cushion", "cloth", "tip", "pocket", "wood"). Values
/// that are empty are the defaults of sound/source/defaults.h.
struct SoundMaterial {
    std::string name;
    std::optional<double> modulus;  // Pa
    std::optional<double> poisson;
    std::optional<double> loss;
    std::optional<double> contact;  // s
    std::optional<std::vector<sound::Mode>> modes;
};

struct SoundSettings {
    bool is_silent = false;  // the film has no sound
    sound::RoomSettings room;
    double bed_reflection = 0.85;  // of the pressure, [0, 1]
    CameraSound cameras;           // of all cameras that do not say otherwise
    /// Pressure of full scale, Pa; empty: so that the film's true peak is -1 dBTP.
    std::optional<double> full_scale;
    std::optional<double> loudness;  // LUFS, with a limiter
    std::vector<SoundMaterial> materials;
};

}  // namespace carom::pipeline
