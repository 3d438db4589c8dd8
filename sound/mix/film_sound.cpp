#include "sound/mix/film_sound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "core/assert.h"
#include "core/error.h"
#include "sound/level/decibels.h"
#include "sound/level/loudness.h"
#include "sound/mix/film_blocks.h"
#include "sound/mix/film_samples.h"

namespace carom::sound {

class FilmSound::Implementation {
  public:
    Implementation(SoundScene scene, const FilmSoundOptions& options, const WorkContext& context)
        : scene_(std::move(scene)), whole_(scene_, std::nullopt) {
        if (options.gain) {
            gain_ = *options.gain;
            whole_.add(options.added, gain_.added);
        } else {
            gain_ = find_gain(scene_, whole_, options.added, context);
        }
        if (options.only) {
            part_.emplace(scene_, options.only);
        } else if (options.only_added) {
            silence_.frames = scene_.frames;
            part_.emplace(silence_, std::nullopt);
            part_->add(options.added, gain_.added);
        }
        samples_.emplace(scene_.frames, gain_, whole_, part_ ? &*part_ : nullptr);
    }
    // The blocks refer to the scene.
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;
    Implementation(Implementation&&) = delete;
    Implementation& operator=(Implementation&&) = delete;
    ~Implementation() = default;

    [[nodiscard]] std::int64_t frames() const { return scene_.frames; }
    [[nodiscard]] std::int64_t position() const { return samples_->position(); }

    [[nodiscard]] FilmGain gain() const {
        FilmGain gain = gain_;
        gain.limits = gain.limits && (position() < frames() || samples_->limited() > 0);
        return gain;
    }

    std::size_t read(std::span<double> left, std::span<double> right) {
        const std::size_t count = samples_->read(left, right);
        meter_.add(left.first(count), right.first(count));
        return count;
    }

    [[nodiscard]] SoundLevels levels() const {
        return {meter_.integrated(), decibels_of(meter_.true_peak()), samples_->limited()};
    }

    [[nodiscard]] std::optional<double> gentle_loudness(const WorkContext& context) {
        CAROM_ASSERT(position() == frames());
        const SoundLevels found = levels();
        const bool is_automatic = !scene_.full_scale && !scene_.loudness;
        const bool is_quiet = std::isfinite(found.loudness) && found.loudness < kQuietFilm;
        if (!is_automatic || !is_quiet ||
            std::ranges::all_of(scene_.shots, [](const auto& s) { return s.passages.empty(); })) {
            return std::nullopt;
        }
        FilmGain gain = gain_;
        gain.full_scale *= factor_of(found.true_peak - kHighestTruePeak - kGentlyLimited);
        gain.limits = true;
        FilmSamples samples(scene_.frames, gain, whole_);
        LoudnessMeter meter;
        std::array<double, 4096> left{};
        std::array<double, 4096> right{};
        while (const std::size_t count = samples.read(left, right)) {
            if (context.stop.stop_requested()) {
                throw Stopped();
            }
            meter.add(std::span(left).first(count), std::span(right).first(count));
        }
        return meter.integrated();
    }

  private:
    SoundScene scene_;
    SoundScene silence_;  // in which the added sound is alone
    FilmBlocks whole_;
    std::optional<FilmBlocks> part_;  // what is wanted of it; empty: all
    FilmGain gain_;
    std::optional<FilmSamples> samples_;
    LoudnessMeter meter_;
};

FilmSound::FilmSound(SoundScene scene, const FilmSoundOptions& options, const WorkContext& context)
    : implementation_(std::make_unique<Implementation>(std::move(scene), options, context)) {}
FilmSound::~FilmSound() = default;
FilmSound::FilmSound(FilmSound&&) noexcept = default;
FilmSound& FilmSound::operator=(FilmSound&&) noexcept = default;

std::int64_t FilmSound::frames() const {
    return implementation_->frames();
}

std::int64_t FilmSound::position() const {
    return implementation_->position();
}

FilmGain FilmSound::gain() const {
    return implementation_->gain();
}

std::size_t FilmSound::read(std::span<double> left, std::span<double> right) {
    return implementation_->read(left, right);
}

std::optional<double> FilmSound::gentle_loudness(const WorkContext& context) {
    return implementation_->gentle_loudness(context);
}

SoundLevels FilmSound::levels() const {
    return implementation_->levels();
}

}  // namespace carom::sound
