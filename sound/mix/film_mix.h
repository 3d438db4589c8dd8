// All sounds of a film in pascals, without its gain.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sound/mix/added_sound.h"
#include "sound/mix/auralisation.h"
#include "sound/mix/onsets.h"
#include "sound/mix/shot_mix.h"
#include "sound/sound_scene.h"

namespace carom::sound {

/// Blocks of kBlock samples, as often as they are wanted. Those of a film of up to kMaxKept
/// samples are kept, so that they are mixed once; longer films are mixed again each time, because
/// memory must not grow with their length.
class FilmMix {
  public:
    static constexpr std::int64_t kMaxKept = 40 * std::int64_t{kSampleRate};  // 31 MB

    /// `only`: of this group alone.
    explicit FilmMix(SoundScene scene, std::optional<Group> only = std::nullopt);
    FilmMix(const FilmMix&) = delete;
    FilmMix& operator=(const FilmMix&) = delete;
    FilmMix(FilmMix&&) = delete;
    FilmMix& operator=(FilmMix&&) = delete;
    ~FilmMix() = default;

    [[nodiscard]] const SoundScene& scene() const { return scene_; }

    /// From the next rewind() on, blocks contain this sound too; a sample of 1 is `pascals`.
    void add(AddedSound sound, double pascals);

    /// Begins again with the film's first block.
    void rewind();

    /// Replaces the samples, of kBlock each, by the next block. Blocks after the film's end exist,
    /// too: what rings then continues.
    void next(std::span<double> left, std::span<double> right);

  private:
    void begin();
    void start_voices();
    void mix(std::span<double> left, std::span<double> right);
    void add_next(std::span<double> left, std::span<double> right);

    const SoundScene scene_;
    std::optional<Group> only_;
    bool keeps_;
    Auralisation auralisation_;
    std::vector<Onset> onsets_;
    double look_ahead_;         // s, by which mirrored sounds may begin before their instant
    std::vector<double> kept_;  // of each block the left samples, then the right ones
    std::size_t read_ = 0;      // of the kept samples
    // Of the next block that is not kept.
    std::vector<ShotMix> shots_;
    std::size_t next_onset_ = 0;
    std::int64_t block_ = 0;  // its first sample

    AddedSound added_;
    double pascals_ = 0;   // of a sample of 1 of the added sound
    SampleReader reader_;  // of the added sound; empty before it begins and after its end
};

}  // namespace carom::sound
