// Sentences about the gain of a film.
#pragma once

#include <optional>
#include <string>

#include "sound/mix/film_gain.h"
#include "sound/mix/film_sound.h"
#include "sound/sound_scene.h"

namespace carom::pipeline {

/// Empty, or a sentence for the user that says by how much the film misses the loudness that the
/// scene asks for, why, and what to change.
[[nodiscard]] std::string missed_loudness_note(const sound::SoundScene& scene,
                                               const sound::FilmGain& gain);

/// Empty, or a sentence that says that the film reaches its loudness, but sounds dull, and which
/// one avoids it.
[[nodiscard]] std::string dull_sound_note(const sound::SoundScene& scene,
                                          const sound::FilmGain& gain);

/// Empty, or a sentence that says that a film which asks for no loudness is far quieter than what
/// platforms play, and what to ask for: at most kPlatformLoudness, and no more than sounds good.
/// `gentle`: FilmSound::gentle_loudness().
[[nodiscard]] std::string quiet_film_note(double loudness, std::optional<double> gentle);

/// What platforms bring films and music to, LUFS, the quieter of two: Spotify and others -14, Apple
/// -16 (docs/sound.md says where that is written).
inline constexpr double kPlatformLoudness = -16;

/// Empty, or a sentence that says that the loudest sounds of a film with a fixed gain were turned
/// down, and what avoids it. `levels`: of the whole film.
[[nodiscard]] std::string fixed_gain_note(const sound::SoundScene& scene, bool has_music,
                                          const sound::SoundLevels& levels);

}  // namespace carom::pipeline
