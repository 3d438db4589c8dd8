#include "sound/rolling/clip_block.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace carom::sound {
namespace {

constexpr double kFastest = 2;        // playing speed
constexpr double kFadesBelow = 0.01;  // of the film's speed
constexpr double kStands = 1e-6;

}  // namespace

double playing_speed(double speed, const ClipSettings& settings) {
    const double magnitude = std::max(std::abs(speed), settings.lowest);
    return std::min(settings.pitch == 1 ? magnitude : power(magnitude, settings.pitch), kFastest);
}

ClipBlock::ClipBlock(const Clip& clip, std::int64_t first_sample, std::size_t count)
    : first(first_sample),
      dynamics(clip.settings.ratio),
      scene_time(count),
      speed(count),
      ratio(count),
      fade(count) {
    for (std::size_t n = 0; n < count; ++n) {
        const double film_time = time_of_sample(first_sample + static_cast<std::int64_t>(n));
        scene_time[n] = clip.scene_time(film_time);
        const double magnitude = std::abs(clip.speed(film_time));
        if (magnitude > kStands) {
            speed[n] = playing_speed(magnitude, clip.settings);
            ratio[n] = speed[n] / magnitude;
            fade[n] = std::min(1.0, magnitude / kFadesBelow);
        }
    }
}

}  // namespace carom::sound
