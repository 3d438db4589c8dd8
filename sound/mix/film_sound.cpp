#include "sound/mix/film_sound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/assert.h"
#include "core/error.h"
#include "sound/level/decibels.h"
#include "sound/level/limiter.h"
#include "sound/level/loudness.h"
#include "sound/level/true_peak.h"
#include "sound/mix/film_blocks.h"

namespace carom::sound {
namespace {

constexpr double kHighestTruePeak = -1;  // dBTP, of a film whose gain is found
constexpr double kLeastFullScale = 0.2;  // Pa: 80 dB, so that silence is not blown up to a roar
constexpr double kEndFade = 240;         // samples, 5 ms

using Block = std::array<double, kBlock>;

/// Hands all blocks of the film to `sink`.
template <class Sink>
void mix_all(const SoundScene& scene, FilmBlocks& blocks, const WorkContext& context,
             const Sink& sink) {
    blocks.rewind();
    constexpr auto kSamples = static_cast<std::int64_t>(kBlock);
    for (std::int64_t frame = 0; frame < scene.frames; frame += kSamples) {
        if (context.stop.stop_requested()) {
            throw Stopped();
        }
        Block left{};
        Block right{};
        blocks.next(left, right);
        const auto count = static_cast<std::size_t>(std::min(scene.frames - frame, kSamples));
        sink(std::span(left).first(count), std::span(right).first(count));
        if (context.progress) {
            context.progress(static_cast<double>(frame) / static_cast<double>(scene.frames));
        }
    }
    if (context.progress) {
        context.progress(1);
    }
}

/// The pressure of a level (dB), which is rounded upwards to a hundredth: the peak stays below its
/// limit.
double rounded_pressure(double level) {
    return pressure_of(std::ceil(level * 100) / 100);
}

double full_scale_for_peak(const SoundScene& scene, FilmBlocks& blocks,
                           const WorkContext& context) {
    TruePeakMeter left_meter;
    TruePeakMeter right_meter;
    mix_all(scene, blocks, context, [&](std::span<double> left, std::span<double> right) {
        left_meter.add(left);
        right_meter.add(right);
    });
    const double peak =
        std::max(left_meter.peak(), right_meter.peak()) / factor_of(kHighestTruePeak);
    return peak > kLeastFullScale ? rounded_pressure(level_of(peak)) : kLeastFullScale;
}

/// The meter leaves out what is below -70 LUFS, so its result depends on the full scale that it
/// measures with. The second measurement uses what the first has found.
double full_scale_for_loudness(const SoundScene& scene, FilmBlocks& blocks,
                               const WorkContext& context) {
    double full_scale = kLeastFullScale;
    for (int pass = 0; pass < 2; ++pass) {
        LoudnessMeter meter;
        WorkContext part = context;
        if (context.progress) {
            part.progress = [&context, pass](double done) { context.progress((pass + done) / 2); };
        }
        mix_all(scene, blocks, part, [&](std::span<double> left, std::span<double> right) {
            for (const std::span<double> channel : {left, right}) {
                std::ranges::transform(channel, channel.begin(),
                                       [full_scale](double x) { return x / full_scale; });
            }
            meter.add(left, right);
        });
        if (std::isfinite(meter.integrated())) {
            full_scale =
                rounded_pressure(level_of(full_scale) + meter.integrated() - *scene.loudness);
        }
    }
    return full_scale;
}

double full_scale_of(const SoundScene& scene, FilmBlocks& blocks, const WorkContext& context) {
    if (scene.loudness) {
        return full_scale_for_loudness(scene, blocks, context);
    }
    return scene.full_scale ? *scene.full_scale : full_scale_for_peak(scene, blocks, context);
}

}  // namespace

class FilmSound::Implementation {
  public:
    Implementation(SoundScene scene, const FilmSoundOptions& options, const WorkContext& context)
        : scene_(std::move(scene)),
          blocks_(scene_, options.only),
          full_scale_(full_scale_of(scene_, blocks_, context)) {
        blocks_.rewind();
        if (scene_.loudness) {
            limiter_.emplace(factor_of(kHighestTruePeak));
            to_skip_ = Limiter::kDelay;
        }
    }
    // The blocks refer to the scene.
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;
    Implementation(Implementation&&) = delete;
    Implementation& operator=(Implementation&&) = delete;
    ~Implementation() = default;

    [[nodiscard]] std::int64_t frames() const { return scene_.frames; }
    [[nodiscard]] std::int64_t position() const { return position_; }
    [[nodiscard]] double full_scale() const { return full_scale_; }

    std::size_t read(std::span<double> left, std::span<double> right) {
        CAROM_ASSERT(left.size() == right.size());
        const auto count = static_cast<std::size_t>(
            std::min<std::int64_t>(static_cast<std::int64_t>(left.size()), frames() - position_));
        for (std::size_t done = 0; done < count;) {
            if (next_ == kBlock) {
                make_block();
                continue;
            }
            const std::size_t part = std::min(count - done, kBlock - next_);
            for (std::size_t i = 0; i < part; ++i) {
                const double fade = fade_at(position_ + static_cast<std::int64_t>(i));
                left[done + i] = fade * left_[next_ + i];
                right[done + i] = fade * right_[next_ + i];
            }
            meter_.add(left.subspan(done, part), right.subspan(done, part));
            done += part;
            next_ += part;
            position_ += static_cast<std::int64_t>(part);
        }
        return count;
    }

    [[nodiscard]] SoundLevels levels() const {
        return {meter_.integrated(), decibels_of(meter_.true_peak()),
                limiter_ ? -decibels_of(limiter_->lowest_factor()) : 0};
    }

  private:
    [[nodiscard]] double fade_at(std::int64_t frame) const {
        return std::min(1.0, static_cast<double>(frames() - 1 - frame) / kEndFade);
    }

    void make_block() {
        blocks_.next(left_, right_);
        for (std::size_t n = 0; n < kBlock; ++n) {
            left_[n] /= full_scale_;
            right_[n] /= full_scale_;
        }
        next_ = 0;
        if (limiter_) {
            limiter_->run(left_, right_);
            next_ = std::min(to_skip_, kBlock);
            to_skip_ -= next_;
        }
    }

    SoundScene scene_;
    FilmBlocks blocks_;
    double full_scale_;
    std::optional<Limiter> limiter_;
    LoudnessMeter meter_;
    Block left_{}, right_{};  // samples that are ready
    std::size_t next_ = kBlock;
    std::size_t to_skip_ = 0;  // samples by which the limiter is late
    std::int64_t position_ = 0;
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

double FilmSound::full_scale() const {
    return implementation_->full_scale();
}

std::size_t FilmSound::read(std::span<double> left, std::span<double> right) {
    return implementation_->read(left, right);
}

SoundLevels FilmSound::levels() const {
    return implementation_->levels();
}

}  // namespace carom::sound
