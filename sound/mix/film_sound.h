// The sound of a whole film: it mixes impacts and rolling of all shots, as the film's passages show
// them, into two channels of samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "core/progress.h"
#include "sound/mix/added_sound.h"
#include "sound/mix/film_gain.h"
#include "sound/sound_scene.h"

namespace carom::sound {

/// What of a film is wanted.
struct FilmSoundOptions {
    /// Is mixed with what is computed, at its own level beside the film's automatic gain or its
    /// fixed one. Then the whole has the loudness that is asked for, or else a true peak below its
    /// limit.
    AddedSound added{};
    /// This group alone, or the added sound alone, for files of single groups, whose sum is the
    /// film's sound: a limiter turns all of them down as the whole needs it.
    std::optional<Group> only{};
    bool only_added = false;
    /// Of the whole film (FilmSound::gain()); empty: it is found.
    std::optional<FilmGain> gain{};
};

/// Levels of samples in units of full scale.
struct SoundLevels {
    double loudness = 0;   // LUFS, integrated (ITU-R BS.1770-4); minus infinity for silence
    double true_peak = 0;  // dBTP, the higher of both channels; minus infinity for silence
    double limited = 0;    // dB, >= 0: the most that the limiter took away
};

/// The loudness of films for television, LUFS (EBU R 128, 2023); a film below it is quiet anywhere.
inline constexpr double kQuietFilm = -23;

/// The samples come in order, in blocks of any size: their bits do not depend on it, nor on
/// threads. Memory does not grow with the film's length. Used by one thread at a time.
class FilmSound {
  public:
    /// Copies `scene`, whose timelines must outlive this object. Unless the scene has a fixed
    /// `full_scale`, the whole film is mixed here to find its gain; progress and stop token are for
    /// that. Throws Stopped, and what the added sound throws.
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

    /// The gain of the whole film. After its last sample was read, it is known whether a film with
    /// a fixed gain needed the limiter.
    [[nodiscard]] FilmGain gain() const;

    /// Fills the channels, which have the same size, with the next samples in units of full scale.
    /// Returns how many were written to each: less than asked for only at the film's end. The true
    /// peak of the whole film is at most kHighestTruePeak.
    [[nodiscard]] std::size_t read(std::span<double> left, std::span<double> right);

    /// The levels of all samples that have been read so far.
    [[nodiscard]] SoundLevels levels() const;

    /// The loudness that the film could have if a limiter turned its loudest sounds down by
    /// kGentlyLimited, LUFS; empty unless its gain is automatic, something is computed in it and it
    /// has less than kQuietFilm. After its last sample was read, which it hears once more. Throws
    /// Stopped.
    [[nodiscard]] std::optional<double> gentle_loudness(const WorkContext& context = {});

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace carom::sound
