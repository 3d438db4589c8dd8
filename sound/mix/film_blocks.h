// The mix of a film, as often as it is wanted.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sound/mix/added_sound.h"
#include "sound/mix/film_mix.h"
#include "sound/sound_scene.h"

namespace carom::sound {

/// Blocks of kBlock samples, Pa. Those of a film of up to kMostKept samples are kept, so that they
/// are mixed once, however often they are read; longer films are mixed again each time, because
/// memory must not grow with their length.
class FilmBlocks {
  public:
    static constexpr std::int64_t kMostKept = 40 * std::int64_t{kSampleRate};  // 31 MB

    /// The scene is borrowed. `only`: as in FilmMix.
    FilmBlocks(const SoundScene& scene, std::optional<Group> only);

    /// From the next rewind() on, blocks contain this sound too; a sample of 1 is `pascals`.
    void add(AddedSound sound, double pascals);

    /// Begins again with the film's first block.
    void rewind();

    /// Replaces the samples, of kBlock each, by the next block. Blocks after the film's end exist,
    /// too.
    void next(std::span<double> left, std::span<double> right);

  private:
    void next_computed(std::span<double> left, std::span<double> right);
    void next_added(std::span<double> left, std::span<double> right);

    const SoundScene& scene_;
    std::optional<Group> only_;
    bool keeps_;
    std::unique_ptr<FilmMix> mix_;  // has made the kept blocks, or all that were read
    std::vector<double> kept_;      // of each block the left samples, then the right ones
    std::size_t read_ = 0;          // of the kept samples
    AddedSound added_;
    double pascals_ = 0;   // of a sample of 1 of the added sound
    SampleReader reader_;  // of the added sound; empty before it begins and after its end
};

}  // namespace carom::sound
