#include "pipeline/sound/loudness_note.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "core/text.h"
#include "sound/level/decibels.h"

namespace carom::pipeline {

namespace {

constexpr double kNear = 0.2;           // LU; a film that is so near has the loudness
constexpr double kLoudnessBlock = 0.4;  // s (ITU-R BS.1770-4)
constexpr double kWorthAWarning = 0.1;  // dB
constexpr double kWorthAsking = 3;      // LU that a film gains

std::string lufs(double loudness) {
    return decimal_text(loudness, 1) + " LUFS";
}

/// What a user may ask for instead: at most as loud, in whole LUFS.
std::string whole_lufs(double loudness) {
    return fmt::format("{:.0f} LUFS", std::floor(loudness));
}

}  // namespace

std::string missed_loudness_note(const sound::SoundScene& scene, const sound::FilmGain& gain) {
    if (!gain.found) {
        return {};
    }
    const double asked = *scene.loudness;
    if (!std::isfinite(gain.found->loudness)) {
        const bool is_short =
            static_cast<double>(scene.frames) < kLoudnessBlock * sound::kSampleRate;
        return fmt::format(
            "the film does not have {}, because it is {}; its true peak is at most {} dB",
            lufs(asked),
            is_short ? "shorter than 0.4 s, over which loudness is measured" : "silent",
            sound::kHighestTruePeak);
    }
    const double missing = asked - gain.found->loudness;
    if (std::abs(missing) <= kNear) {
        return {};
    }
    const std::string reached =
        fmt::format("the film has {} instead of {}", lufs(gain.found->loudness), lufs(asked));
    if (missing < 0) {
        return reached + "; the nearest that was found";
    }
    return fmt::format(
        "{}, {:.1f} LU less: its loudest sounds are short and far above the rest, and are already "
        "turned down by {:.0f} dB. Ask for {}; a higher 'dynamics', up to 4, may help, since it "
        "brings loud and quiet sounds nearer to each other",
        reached, missing, gain.found->limited,
        whole_lufs(gain.found->gentle.value_or(gain.found->loudness)));
}

std::string dull_sound_note(const sound::SoundScene& scene, const sound::FilmGain& gain) {
    if (!gain.found || !gain.found->gentle || !missed_loudness_note(scene, gain).empty()) {
        return {};
    }
    return fmt::format(
        "for {} the loudest sounds are turned down by {:.1f} dB; with more than {:.0f} dB they "
        "sound dull, which {} would avoid; a higher 'dynamics' may help",
        lufs(*scene.loudness), gain.found->limited, sound::kGentlyLimited,
        whole_lufs(*gain.found->gentle));
}

std::string quiet_film_note(double loudness, std::optional<double> gentle) {
    if (!gentle) {
        return {};
    }
    const double louder = std::min(*gentle, kPlatformLoudness);
    return fmt::format(
        "the film has {}, and platforms play films at -14 to {}; {}", lufs(loudness),
        lufs(kPlatformLoudness),
        louder < loudness + kWorthAsking
            ? "its loudest sounds are short and far above the rest: a higher 'dynamics', up to 4, "
              "brings them nearer to it, and then 'loudness' can make the film louder"
            : fmt::format("'sound: {{loudness: {}}}' makes it louder", whole_lufs(louder)));
}

std::string fixed_gain_note(const sound::SoundScene& scene, bool has_music,
                            const sound::SoundLevels& levels) {
    if (!scene.full_scale || scene.loudness || levels.limited < kWorthAWarning) {
        return {};
    }
    const double avoids = *scene.full_scale * sound::factor_of(levels.limited);
    return fmt::format(
        "with the fixed gain the loudest sounds exceed the highest true peak, {} dB, so they are "
        "turned down by {:.1f} dB; {} avoids it",
        sound::kHighestTruePeak, levels.limited,
        has_music ? "a larger 'full_scale', or a lower 'gain' of the music,"
                  : "'full_scale: " + decimal_text(std::ceil(avoids * 10) / 10, 1) + " Pa'");
}

}  // namespace carom::pipeline
