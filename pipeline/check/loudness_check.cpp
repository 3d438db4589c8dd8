// Warns of a loudness that a film does not reach, or only by much limiting.
#include "pipeline/check/motion_check.h"
#include "pipeline/check/placed_problem.h"
#include "pipeline/sound/loudness_note.h"
#include "sound/mix/film_sound.h"

namespace carom::pipeline {

std::vector<Problem> loudness_problems(const sound::SoundScene& film, const ShotSource* source,
                                       const sound::AddedSound& music, const WorkContext& context) {
    if (!film.loudness || film.frames == 0) {
        return {};
    }
    const sound::FilmGain gain = sound::FilmSound(film, {.added = music}, context).gain();
    std::vector<Problem> problems;
    for (const std::string& note :
         {missed_loudness_note(film, gain), dull_sound_note(film, gain)}) {
        if (!note.empty()) {
            problems.push_back(
                placed_problem(source, {"sound", "loudness"}, Severity::warning, note));
        }
    }
    return problems;
}

}  // namespace carom::pipeline
