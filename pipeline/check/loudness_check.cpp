// Warns of a loudness that a film does not reach, or only by much limiting, and of a fixed gain
// that is too high.
#include <array>

#include "core/error.h"
#include "pipeline/check/motion_check.h"
#include "pipeline/check/placed_problem.h"
#include "pipeline/sound/loudness_note.h"
#include "sound/mix/film_sound.h"

namespace carom::pipeline {

namespace {

constexpr std::size_t kBlock = 4096;

/// The levels of the whole film.
sound::SoundLevels levels_of(sound::FilmSound& film, const WorkContext& context) {
    std::array<double, kBlock> left{};
    std::array<double, kBlock> right{};
    while (film.read(left, right) > 0) {
        if (context.stop.stop_requested()) {
            throw Stopped();
        }
    }
    return film.levels();
}

}  // namespace

std::vector<Problem> loudness_problems(const sound::SoundScene& film, const ShotSource* source,
                                       const sound::AddedSound& music, const WorkContext& context) {
    std::vector<Problem> problems;
    const auto warn = [&](const std::vector<std::string>& path, const std::string& note) {
        if (!note.empty()) {
            problems.push_back(placed_problem(source, path, Severity::warning, note));
        }
    };
    if (film.frames == 0 || (!film.loudness && !film.full_scale)) {
        return problems;
    }
    sound::FilmSound sound(film, {.added = music}, context);
    if (film.loudness) {
        warn({"sound", "loudness"}, missed_loudness_note(film, sound.gain()));
        warn({"sound", "loudness"}, dull_sound_note(film, sound.gain()));
    } else {
        warn({"sound", "gain", "full_scale"},
             fixed_gain_note(film, static_cast<bool>(music), levels_of(sound, context)));
    }
    return problems;
}

}  // namespace carom::pipeline
