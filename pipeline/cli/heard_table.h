// What is heard in a film, as a table and as lines for people.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "sound/mix/auralisation.h"
#include "sound/mix/film_sound.h"

namespace carom::cli {

/// Columns film_time,scene_time,kind,a,b,camera,speed,time_factor,distance,delay,impulse,
/// contact_time,peak_time,peak,gain, one row per impact in order of film time: s, m, N s, Pa at the
/// listener before the gain, dB.
[[nodiscard]] std::string heard_to_csv(std::span<const sound::AudibleImpact> heard);

/// What a report says of a whole film.
struct FilmLoudness {
    sound::SoundLevels levels;
    double full_scale = 1;          // Pa
    std::optional<double> asked{};  // LUFS
    bool has_music = false;
};

/// Loudness and true peak, the pressure of full scale, and the loudest ten impacts.
[[nodiscard]] std::string sound_report(const FilmLoudness& film,
                                       std::span<const sound::AudibleImpact> heard);

}  // namespace carom::cli
