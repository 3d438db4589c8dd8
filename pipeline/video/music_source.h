// A file with music under the sound of a film.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "pipeline/video/output_settings.h"
#include "pipeline/video/sound_decoder.h"
#include "pipeline/video/sound_source.h"

namespace carom::pipeline {

/// Adds the sound of a file to another sound. For one thread at a time.
class MusicSource : public SoundSource {
  public:
    /// `film_samples`: the length of the whole film, at whose end the music has faded out. `sound`:
    /// what it is added to, or null. Throws Error as SoundDecoder does.
    MusicSource(const MusicSettings& settings, std::int64_t film_samples,
                std::unique_ptr<SoundSource> sound);

    /// As of SoundSource. It ends where both have ended; the music ends with the film at the
    /// latest.
    std::size_t read(std::span<double> left, std::span<double> right) override;

  private:
    /// The factor of the music at a sample of the film.
    [[nodiscard]] double gain_at(std::int64_t sample) const;

    SoundDecoder music_;
    std::unique_ptr<SoundSource> sound_;
    std::int64_t film_samples_;
    double gain_;  // a factor
    double fade_;  // samples
    std::int64_t at_ = 0;
    std::array<double, kSoundBlock> left_{};  // of the music
    std::array<double, kSoundBlock> right_{};
};

}  // namespace carom::pipeline
