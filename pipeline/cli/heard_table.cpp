#include "pipeline/cli/heard_table.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "sound/level/decibels.h"

namespace carom::cli {

namespace {

/// The level at the listener after the gain, dB.
double level_of(const sound::AudibleImpact& heard) {
    return sound::level_of(heard.peak) + heard.gain;
}

std::string pair_text(const sound::AudibleImpact& heard) {
    return heard.b.empty() ? heard.a : heard.a + " - " + heard.b;
}

/// "-16.2 LUFS", or `otherwise` for minus infinity.
std::string level_text(double level, const char* unit, const char* otherwise = "silence") {
    return std::isfinite(level) ? fmt::format("{:.1f} {}", level, unit) : otherwise;
}

}  // namespace

std::string heard_to_csv(std::span<const sound::AudibleImpact> heard) {
    std::string text =
        "film_time,scene_time,kind,a,b,camera,speed,time_factor,distance,delay,impulse,"
        "contact_time,peak_time,peak,gain\n";
    for (const sound::AudibleImpact& one : heard) {
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{:.4f}\n", one.film_time,
                            one.scene_time, sim::to_string(one.kind), one.a, one.b, one.camera,
                            one.speed, one.time_factor, one.distance, one.delay, one.impulse,
                            one.contact_time, one.peak_time, one.peak, one.gain);
    }
    return text;
}

std::string sound_report(const FilmLoudness& film, std::span<const sound::AudibleImpact> heard) {
    constexpr std::size_t kLines = 10;
    const std::string asked = film.asked ? fmt::format(" (asked for: {:g})", *film.asked) : "";
    std::string text = fmt::format(
        "loudness    {}{}\ntrue peak   {}\nfull scale  {:.3g} Pa ({:.1f} dB)\n",
        level_text(film.levels.loudness, "LUFS",
                   std::isfinite(film.levels.true_peak) ? "none: shorter than 0.4 s" : "silence"),
        asked, level_text(film.levels.true_peak, "dBTP"), film.full_scale,
        sound::level_of(film.full_scale));
    if (film.levels.limited > 0) {
        text += fmt::format("limited by  {:.1f} dB at most\n", film.levels.limited);
    }
    if (film.has_music) {
        text += "music       is included\n";
    }
    text += fmt::format("impacts     {}\n", heard.size());
    std::vector<sound::AudibleImpact> loudest(std::min(kLines, heard.size()));
    std::ranges::partial_sort_copy(
        heard, loudest, [](const auto& a, const auto& b) { return level_of(a) > level_of(b); });
    if (!loudest.empty()) {
        text += fmt::format("\n{:>9}  {:>9}  {:<30} {:<14} {:>6} {:>9} {:>8}\n", "film s",
                            "scene s", "the loudest", "camera", "m", "Pa", "dB");
    }
    for (const sound::AudibleImpact& one : loudest) {
        text += fmt::format("{:9.4f}  {:9.4f}  {:<30} {:<14} {:6.2f} {:9.3g} {:8.1f}\n",
                            one.film_time, one.scene_time, pair_text(one), one.camera, one.distance,
                            one.peak, level_of(one));
    }
    return text;
}

}  // namespace carom::cli
