// A file with music under the sound of a film.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "pipeline/video/output_settings.h"
#include "pipeline/video/sound_decoder.h"
#include "pipeline/video/sound_source.h"
#include "sound/mix/added_sound.h"

namespace carom::pipeline {

/// Plays the sound of a file. For one thread at a time.
class MusicSource : public SoundSource {
  public:
    /// `film_samples`: the length of the whole film, at whose end the music has faded out and ends
    /// at the latest. Throws Error as SoundDecoder does.
    MusicSource(const MusicSettings& settings, std::int64_t film_samples);

    std::size_t read(std::span<double> left, std::span<double> right) override;

  private:
    /// The factor of the music at a sample of the film.
    [[nodiscard]] double gain_at(std::int64_t sample) const;

    SoundDecoder music_;
    std::int64_t film_samples_;
    double gain_;  // a factor
    double fade_;  // samples
    std::int64_t at_ = 0;
};

/// Music to be mixed with the computed sound of a film. Opens the file once, so that an error is
/// known before anything is rendered. Throws Error as SoundDecoder does.
[[nodiscard]] sound::AddedSound music_of(const MusicSettings& settings, std::int64_t film_samples);

}  // namespace carom::pipeline
