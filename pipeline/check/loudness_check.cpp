// Warns of a loudness that a film reaches only by much limiting.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/check/motion_check.h"
#include "pipeline/check/placed_problem.h"
#include "pipeline/sound/film_scene.h"
#include "sound/mix/film_sound.h"

namespace carom::pipeline {

namespace {

constexpr double kMostLimited = 12;  // dB; impacts that are cut by more sound dull (tuned)

/// By how much the limiter turns the film's loudest sound down, dB.
double most_limited(sound::FilmSound film) {
    std::array<double, 4096> left{};
    std::array<double, 4096> right{};
    while (film.read(left, right) > 0) {
    }
    return film.levels().limited;
}

}  // namespace

std::vector<Problem> loudness_problems(const Shot& shot, const ShotSource* source,
                                       const sim::Timeline& timeline, const WorkContext& context) {
    const std::int64_t frames = frame_count(shot.cameras, shot.timing);
    if (shot.sound.is_silent || !shot.sound.loudness || frames == 0) {
        return {};
    }
    const double limited =
        most_limited(sound::FilmSound(film_scene(shot, timeline, 0, frames), {}, context));
    if (limited <= kMostLimited) {
        return {};
    }
    // A decibel less of loudness is a decibel less that the limiter takes away.
    const double better = std::floor(*shot.sound.loudness - (limited - kMostLimited));
    const std::string message = fmt::format(
        "for {} LUFS the loudest sounds are turned down by {:.1f} dB; with more than {} dB they "
        "sound dull, which {} LUFS would avoid",
        decimal_text(*shot.sound.loudness, 2), limited, kMostLimited, better);
    return {placed_problem(source, {"sound", "loudness"}, Severity::warning, message)};
}

}  // namespace carom::pipeline
