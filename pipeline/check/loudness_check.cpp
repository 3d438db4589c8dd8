// Warns of a loudness that a film does not reach, or only by much limiting, and of a fixed gain
// that is too high.
#include "pipeline/check/motion_check.h"
#include "pipeline/check/placed_problem.h"
#include "pipeline/sound/loudness_note.h"
#include "sound/mix/film_sound.h"

namespace carom::pipeline {

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
        sound.read_rest({{}, context.stop});
        warn({"sound", "gain", "full_scale"},
             fixed_gain_note(film, static_cast<bool>(music), sound.levels()));
    }
    return problems;
}

}  // namespace carom::pipeline
