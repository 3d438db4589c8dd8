#include "pipeline/video/music_source.h"

#include <algorithm>
#include <memory>

#include "core/elementary.h"

namespace carom::pipeline {

MusicSource::MusicSource(const MusicSettings& settings, std::int64_t film_samples)
    : music_(settings.file),
      film_samples_(film_samples),
      gain_(power(10, settings.gain / 20)),
      fade_(settings.fade * kSoundRate) {}

double MusicSource::gain_at(std::int64_t sample) const {
    const auto left = static_cast<double>(film_samples_ - sample);
    if (left >= fade_) {
        return gain_;
    }
    // Slow at both ends, so that neither is heard as a step.
    const double x = std::max(left, 0.0) / fade_;
    return gain_ * x * x * (3 - 2 * x);
}

std::size_t MusicSource::read(std::span<double> left, std::span<double> right) {
    const auto film_left = static_cast<std::size_t>(std::max<std::int64_t>(film_samples_ - at_, 0));
    const std::size_t wanted = std::min(left.size(), film_left);
    if (wanted == 0) {
        return 0;
    }
    const std::size_t count = music_.read(left.first(wanted), right.first(wanted));
    for (std::size_t i = 0; i < count; ++i) {
        const double gain = gain_at(at_ + static_cast<std::int64_t>(i));
        left[i] *= gain;
        right[i] *= gain;
    }
    at_ += static_cast<std::int64_t>(count);
    return count;
}

sound::AddedSound music_of(const MusicSettings& settings, std::int64_t film_samples) {
    const SoundDecoder opened(settings.file);
    return [settings, film_samples] {
        const auto music = std::make_shared<MusicSource>(settings, film_samples);
        return [music](std::span<double> left, std::span<double> right) {
            return music->read(left, right);
        };
    };
}

}  // namespace carom::pipeline
