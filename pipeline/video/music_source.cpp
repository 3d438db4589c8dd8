#include "pipeline/video/music_source.h"

#include <algorithm>
#include <utility>

#include "core/elementary.h"

namespace carom::pipeline {

namespace {

/// Reads until both spans are full or the sound has ended, and returns how many samples it gave.
std::size_t read_all(SoundSource& source, std::span<double> left, std::span<double> right) {
    std::size_t count = 0;
    while (count < left.size()) {
        const std::size_t got = source.read(left.subspan(count), right.subspan(count));
        if (got == 0) {
            break;
        }
        count += got;
    }
    return count;
}

}  // namespace

MusicSource::MusicSource(const MusicSettings& settings, std::int64_t film_samples,
                         std::unique_ptr<SoundSource> sound)
    : music_(settings.file),
      sound_(std::move(sound)),
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
    const std::size_t wanted = std::min(left.size(), kSoundBlock);
    const std::size_t of_sound =
        sound_ == nullptr ? 0 : read_all(*sound_, left.first(wanted), right.first(wanted));
    const auto film_left = static_cast<std::size_t>(std::max<std::int64_t>(film_samples_ - at_, 0));
    const std::size_t music_wanted = std::min(wanted, film_left);
    const std::size_t of_music = read_all(music_, std::span(left_).first(music_wanted),
                                          std::span(right_).first(music_wanted));
    const std::size_t count = std::max(of_sound, of_music);
    std::fill_n(left.begin() + static_cast<std::ptrdiff_t>(of_sound), count - of_sound, 0.0);
    std::fill_n(right.begin() + static_cast<std::ptrdiff_t>(of_sound), count - of_sound, 0.0);
    for (std::size_t i = 0; i < of_music; ++i) {
        const double gain = gain_at(at_ + static_cast<std::int64_t>(i));
        left[i] += gain * left_[i];
        right[i] += gain * right_[i];
    }
    at_ += static_cast<std::int64_t>(count);
    return count;
}

}  // namespace carom::pipeline
