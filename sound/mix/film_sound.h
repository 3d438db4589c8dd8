// The sound of a whole film: it mixes impacts and rolling of all shots, as the film's clips show
// them, into two channels of samples.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "core/progress.h"
#include "sound/level/limiter.h"
#include "sound/level/loudness.h"
#include "sound/mix/added_sound.h"
#include "sound/mix/film_gain.h"
#include "sound/mix/shot_bus.h"
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
/// threads. Memory does not grow with the film's length, except by 32 bytes for each event that the
/// film shows. Used by one thread at a time.
class FilmSound {
  public:
    /// Copies `scene`, whose timelines must outlive this object. Unless the scene has a fixed
    /// `full_scale`, the whole film is mixed here to find its gain; progress and stop token are for
    /// that. Throws Stopped, and what the added sound throws.
    explicit FilmSound(SoundScene scene, const FilmSoundOptions& options = {},
                       const WorkContext& context = {});

    /// The sound of a film that is mixed already, with this gain. It reads `mix` from the
    /// beginning; other sounds that read it cannot continue.
    FilmSound(std::shared_ptr<FilmMix> mix, const FilmGain& gain);

    /// The length of each channel in samples, at kSampleRate.
    [[nodiscard]] std::int64_t frames() const { return frames_; }

    /// How many samples of each channel have been read.
    [[nodiscard]] std::int64_t position() const { return position_; }

    /// The gain of the whole film. After its last sample was read, it is known whether a film with
    /// a fixed gain needed the limiter.
    [[nodiscard]] FilmGain gain() const;

    /// Fills the channels, which have the same size, with the next samples in units of full scale.
    /// Returns how many were written to each: fewer than asked for only at the film's end. The true
    /// peak of the whole film is at most kHighestTruePeak.
    [[nodiscard]] std::size_t read(std::span<double> left, std::span<double> right);

    /// Reads all that is left, and hands each block to `sink`, if there is one. Throws Stopped.
    using Sink = std::function<void(std::span<const double> left, std::span<const double> right)>;
    void read_rest(const WorkContext& context = {}, const Sink& sink = {});

    /// The levels of all samples that have been read so far.
    [[nodiscard]] SoundLevels levels() const;

    /// The loudness that the film could have if a limiter turned its loudest sounds down by
    /// kGentlyLimited, LUFS; empty unless its gain is automatic, something is computed in it and it
    /// has less than kQuietFilm. After its last sample was read, which it hears once more. Throws
    /// Stopped.
    [[nodiscard]] std::optional<double> gentle_loudness(const WorkContext& context = {});

  private:
    using Block = std::array<double, kBlock>;

    void begin();
    void make_block();
    [[nodiscard]] double limited() const;

    std::shared_ptr<FilmMix> whole_;
    std::shared_ptr<FilmMix> part_;  // what is wanted of it; null: all
    std::int64_t frames_;
    FilmGain gain_;
    std::optional<Limiter> limiter_;
    Block left_{}, right_{};  // samples that are ready
    std::size_t next_ = kBlock;
    std::size_t to_skip_ = 0;  // samples by which the limiter is late
    std::int64_t position_ = 0;
    LoudnessMeter meter_;
};

}  // namespace carom::sound
