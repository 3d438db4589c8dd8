#include "sound/mix/film_sound.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/assert.h"
#include "core/error.h"
#include "sound/level/decibels.h"
#include "sound/mix/film_mix.h"

namespace carom::sound {
namespace {

constexpr double kEndFade = 240;  // samples, 5 ms

/// The next block of the mix in units of full scale.
void next_of(FilmMix& mix, double full_scale, std::span<double> left, std::span<double> right) {
    mix.next(left, right);
    for (const std::span<double> channel : {left, right}) {
        for (double& sample : channel) {
            sample /= full_scale;
        }
    }
}

}  // namespace

FilmSound::FilmSound(SoundScene scene, const FilmSoundOptions& options, const WorkContext& context)
    : whole_(std::make_shared<FilmMix>(std::move(scene))), frames_(whole_->scene().frames) {
    if (options.gain) {
        gain_ = *options.gain;
        whole_->add(options.added, gain_.added);
    } else {
        gain_ = find_gain(whole_, options.added, context);
    }
    if (options.only) {
        part_ = std::make_shared<FilmMix>(whole_->scene(), options.only);
    } else if (options.only_added) {
        SoundScene silence;
        silence.frames = frames_;
        part_ = std::make_shared<FilmMix>(std::move(silence));
        part_->add(options.added, gain_.added);
    }
    begin();
}

FilmSound::FilmSound(std::shared_ptr<FilmMix> mix, const FilmGain& gain)
    : whole_(std::move(mix)), frames_(whole_->scene().frames), gain_(gain) {
    begin();
}

void FilmSound::begin() {
    if (gain_.limits) {
        limiter_.emplace(factor_of(kHighestTruePeak));
        to_skip_ = Limiter::kDelay;
    }
    whole_->rewind();
    if (part_) {
        part_->rewind();
    }
}

FilmGain FilmSound::gain() const {
    FilmGain gain = gain_;
    gain.limits = gain.limits && (position_ < frames_ || limited() > 0);
    return gain;
}

void FilmSound::make_block() {
    next_of(part_ ? *part_ : *whole_, gain_.full_scale, left_, right_);
    next_ = 0;
    if (!limiter_) {
        return;
    }
    if (part_) {
        Block key_left{};
        Block key_right{};
        next_of(*whole_, gain_.full_scale, key_left, key_right);
        limiter_->run(key_left, key_right, left_, right_);
    } else {
        limiter_->run(left_, right_);
    }
    next_ = std::min(to_skip_, kBlock);
    to_skip_ -= next_;
}

std::size_t FilmSound::read(std::span<double> left, std::span<double> right) {
    CAROM_ASSERT(left.size() == right.size());
    const auto count = static_cast<std::size_t>(
        std::min<std::int64_t>(static_cast<std::int64_t>(left.size()), frames_ - position_));
    for (std::size_t done = 0; done < count;) {
        if (next_ == kBlock) {
            make_block();
            continue;
        }
        const std::size_t part = std::min(count - done, kBlock - next_);
        for (std::size_t i = 0; i < part; ++i, ++done, ++next_, ++position_) {
            const double fade =
                std::min(1.0, static_cast<double>(frames_ - 1 - position_) / kEndFade);
            left[done] = fade * left_[next_];
            right[done] = fade * right_[next_];
        }
    }
    meter_.add(left.first(count), right.first(count));
    return count;
}

void FilmSound::read_rest(const WorkContext& context, const Sink& sink) {
    std::array<double, 4096> left{};
    std::array<double, 4096> right{};
    while (const std::size_t count = read(left, right)) {
        if (context.stop.stop_requested()) {
            throw Stopped();
        }
        if (sink) {
            sink(std::span(left).first(count), std::span(right).first(count));
        }
        if (context.progress) {
            context.progress(static_cast<double>(position_) / static_cast<double>(frames_));
        }
    }
}

double FilmSound::limited() const {
    return limiter_ ? decibels_of(1 / limiter_->lowest_factor()) : 0;
}

SoundLevels FilmSound::levels() const {
    return {meter_.integrated(), decibels_of(meter_.true_peak()), limited()};
}

std::optional<double> FilmSound::gentle_loudness(const WorkContext& context) {
    CAROM_ASSERT(position_ == frames_);
    const SoundScene& scene = whole_->scene();
    const SoundLevels found = levels();
    const bool is_automatic = !scene.full_scale && !scene.loudness;
    const bool is_quiet = std::isfinite(found.loudness) && found.loudness < kQuietFilm;
    if (!is_automatic || !is_quiet ||
        std::ranges::all_of(scene.shots, [](const auto& s) { return s.clips.empty(); })) {
        return std::nullopt;
    }
    FilmGain gain = gain_;
    gain.full_scale *= factor_of(found.true_peak - kHighestTruePeak - kGentlyLimited);
    gain.limits = true;
    FilmSound louder(whole_, gain);
    louder.read_rest({{}, context.stop});
    return louder.levels().loudness;
}

}  // namespace carom::sound
