// The gain of a whole film.
#pragma once

#include <memory>
#include <optional>

#include "core/progress.h"
#include "sound/mix/added_sound.h"

namespace carom::sound {

class FilmMix;

inline constexpr double kHighestTruePeak = -1;  // dBTP, of every film

/// The most that a film's loudest sounds are turned down for a loudness that is asked for, dB, and
/// what sounds good. With more than the first, a clack is no louder than what is heard all the
/// time; with more than the second it sounds dull (tuned).
inline constexpr double kMaxLimited = 30;
inline constexpr double kGentlyLimited = 12;

/// What became of a loudness that was asked for.
struct FoundLoudness {
    /// LUFS, of the film with its gain; minus infinity if it has none, because it is silent or
    /// shorter than a block of the measurement.
    double loudness = 0;
    double limited = 0;  // dB, by which its loudest sounds are turned down
    /// Of the film whose loudest sounds are turned down by kGentlyLimited, LUFS. Only if `limited`
    /// is more.
    std::optional<double> gentle{};
};

/// How pressures become samples.
struct FilmGain {
    double full_scale = 0.2;               // Pa of a sample of 1, before the limiter
    double added = 0.2;                    // Pa of a sample of 1 of the added sound
    bool limits = false;                   // a limiter keeps the true peak below its limit
    std::optional<FoundLoudness> found{};  // empty unless the scene asks for a loudness
};

/// The gain that the scene of `mix` asks for, of all that is heard, with the added sound, which is
/// added to `mix`. The film is mixed several times, except with a fixed gain. Throws Stopped.
[[nodiscard]] FilmGain find_gain(const std::shared_ptr<FilmMix>& mix, const AddedSound& added,
                                 const WorkContext& context);

}  // namespace carom::sound
