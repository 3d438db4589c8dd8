// The sound of a whole film: it mixes impacts and rolling of all shots, as the film's passages show
// them, into two channels of samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "core/progress.h"
#include "sound/sound_scene.h"

namespace carom::sound {

struct FilmSoundOptions {
    /// Mixes this group alone, for files of single groups. With the scene's `full_scale` set to
    /// that of the whole film (FilmSound::full_scale()) and without `loudness`, the sum of all
    /// groups is the film's sound.
    std::optional<Group> only{};
};

/// Levels of samples in units of full scale.
struct SoundLevels {
    double loudness = 0;   // LUFS, integrated (ITU-R BS.1770-4); minus infinity for silence
    double true_peak = 0;  // dBTP, the higher of both channels; minus infinity for silence
    double limited = 0;    // dB, >= 0: the most that the limiter took away
};

/// The samples come in order, in blocks of any size: their bits do not depend on it, nor on
/// threads. Memory does not grow with the film's length. Used by one thread at a time.
class FilmSound {
  public:
    /// Copies `scene`, whose timelines must outlive this object. Without `full_scale`, or with
    /// `loudness`, the whole film is mixed here a first time to find its gain; progress and stop
    /// token are for that. Throws Stopped.
    explicit FilmSound(SoundScene scene, const FilmSoundOptions& options = {},
                       const WorkContext& context = {});
    ~FilmSound();
    FilmSound(FilmSound&&) noexcept;
    FilmSound& operator=(FilmSound&&) noexcept;
    FilmSound(const FilmSound&) = delete;
    FilmSound& operator=(const FilmSound&) = delete;

    /// The length of each channel in samples, at kSampleRate.
    [[nodiscard]] std::int64_t frames() const;

    /// How many samples of each channel have been read.
    [[nodiscard]] std::int64_t position() const;

    /// The pressure of a sample of 1, Pa.
    [[nodiscard]] double full_scale() const;

    /// Fills the channels, which have the same size, with the next samples in units of full scale.
    /// Returns how many were written to each: less than asked for only at the film's end. Samples
    /// may exceed 1 unless `loudness` is asked for or the full scale is found automatically.
    [[nodiscard]] std::size_t read(std::span<double> left, std::span<double> right);

    /// The levels of all samples that have been read so far.
    [[nodiscard]] SoundLevels levels() const;

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace carom::sound
