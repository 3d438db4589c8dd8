#include "sound/rolling/passage_block.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace carom::sound {
namespace {

constexpr double kFastest = 2;        // playing speed
constexpr double kFadesBelow = 0.01;  // of the film's speed
constexpr double kStands = 1e-6;

}  // namespace

double playing_speed(double speed, const PassageSettings& settings) {
    const double magnitude = std::max(std::abs(speed), settings.lowest);
    return std::min(settings.pitch == 1 ? magnitude : power(magnitude, settings.pitch), kFastest);
}

PassageBlock::PassageBlock(const Passage& passage, std::int64_t first_sample, std::size_t count)
    : first(first_sample),
      dynamics(passage.settings.ratio),
      scene_time(count),
      speed(count),
      ratio(count),
      presence(count) {
    for (std::size_t n = 0; n < count; ++n) {
        const double film_time =
            static_cast<double>(first_sample + static_cast<std::int64_t>(n)) / kSampleRate;
        scene_time[n] = passage.scene_time(film_time);
        const double magnitude = std::abs(passage.speed(film_time));
        if (magnitude > kStands) {
            speed[n] = playing_speed(magnitude, passage.settings);
            ratio[n] = speed[n] / magnitude;
            presence[n] = std::min(1.0, magnitude / kFadesBelow);
        }
    }
}

}  // namespace carom::sound
