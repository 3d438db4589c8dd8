#include "pipeline/sound/film_levels.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/sound/film_scene.h"
#include "sound/level/decibels.h"
#include "sound/mix/film_sound.h"

namespace carom::pipeline {

FilmLevels film_levels(const Shot& shot, const sim::Timeline& timeline,
                       const WorkContext& context) {
    const std::int64_t frames = frame_count(shot.cameras, shot.timing);
    if (shot.sound.is_silent || frames == 0) {
        return {};
    }
    constexpr auto kSamples = static_cast<std::size_t>(FilmLevels::kInterval * sound::kSampleRate);
    sound::FilmSound source(film_scene(shot, timeline, 0, frames), {}, context);
    FilmLevels levels;
    levels.length = static_cast<double>(source.frames()) / sound::kSampleRate;
    std::array<double, kSamples> left{};
    std::array<double, kSamples> right{};
    while (const std::size_t count = source.read(left, right)) {
        double sum = 0;
        for (const std::array<double, kSamples>* channel : {&left, &right}) {
            for (const double sample : std::span(*channel).first(count)) {
                sum += sample * sample;
            }
        }
        levels.decibels.push_back(
            sound::decibels_of(std::sqrt(sum / (2 * static_cast<double>(count)))));
    }
    return levels;
}

}  // namespace carom::pipeline
