#include "sound/mix/film_gain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "core/error.h"
#include "sound/level/decibels.h"
#include "sound/level/loudness.h"
#include "sound/level/true_peak.h"
#include "sound/mix/film_mix.h"
#include "sound/mix/film_sound.h"

namespace carom::sound {
namespace {

constexpr double kMinFullScale = 0.2;  // Pa: 80 dB, so that silence is not blown up to a roar
constexpr double kNearEnough = 0.05;   // LU, of a loudness that is asked for
constexpr int kMaxPasses = 12;         // with the limiter; four are usual

/// Levels (dB) are rounded upwards to a hundredth: the peak stays below its limit, and gains that
/// follow from a loudness are the same on all machines (loudness.h).
double rounded(double level) {
    return std::ceil(level * 100) / 100;
}

/// The level of the full scale with which this peak (Pa) is at its limit.
double level_for_peak(double peak) {
    return level_of(peak / factor_of(kHighestTruePeak));
}

/// A full scale that was tried, and the loudness that the film then has.
struct Trial {
    double level = 0;  // of the full scale, dB; the lower, the louder the film
    double loudness = -std::numeric_limits<double>::infinity();
    double limited = 0;  // dB
};

/// Hears a film as often as it takes to find its gain.
class GainSearch {
  public:
    GainSearch(const std::shared_ptr<FilmMix>& mix, const WorkContext& context)
        : scene_(mix->scene()), mix_(mix), context_(context) {}

    /// The highest true peak of the film, Pa.
    [[nodiscard]] double peak();

    /// The full scale for the scene's loudness, with a limiter, and the loudness with it.
    [[nodiscard]] FilmGain with_loudness(double added);

  private:
    template <class Sink>
    void hear(const Sink& sink);
    std::optional<double> level_without_limiter();
    [[nodiscard]] Trial trial_at(double level);
    [[nodiscard]] Trial nearest(double start, double lowest);
    void report(double part) const;

    const SoundScene& scene_;
    std::shared_ptr<FilmMix> mix_;
    const WorkContext& context_;
    double peak_ = 0;  // Pa
    int passes_ = 0;   // so far
};

/// `part`: of this pass. How many passes there will be is not known, so each takes a part of what
/// is left.
void GainSearch::report(double part) const {
    if (context_.stop.stop_requested()) {
        throw Stopped();
    }
    if (context_.progress) {
        const double done = passes_ + part;
        context_.progress(done / (done + 1));
    }
}

/// Hands all blocks of the film to `sink`, Pa.
template <class Sink>
void GainSearch::hear(const Sink& sink) {
    mix_->rewind();
    constexpr auto kSamples = static_cast<std::int64_t>(kBlock);
    for (std::int64_t frame = 0; frame < scene_.frames; frame += kSamples) {
        report(static_cast<double>(frame) / static_cast<double>(scene_.frames));
        std::array<double, kBlock> left{};
        std::array<double, kBlock> right{};
        mix_->next(left, right);
        const auto count = static_cast<std::size_t>(std::min(scene_.frames - frame, kSamples));
        sink(std::span(left).first(count), std::span(right).first(count));
    }
    ++passes_;
}

double GainSearch::peak() {
    TruePeakMeter left_meter;
    TruePeakMeter right_meter;
    hear([&](std::span<double> left, std::span<double> right) {
        left_meter.add(left);
        right_meter.add(right);
    });
    return std::max(left_meter.peak(), right_meter.peak());
}

/// Returns the level of the full scale for the loudness if no limiter is needed; empty if the film
/// has no loudness at all. The meter leaves out what is below -70 LUFS, so its result depends on
/// the full scale with which it measures: the second measurement uses what the first has found, and
/// a film that is too quiet for the first is measured with its peak at the limit.
std::optional<double> GainSearch::level_without_limiter() {
    double full_scale = kMinFullScale;
    std::optional<double> level;
    for (int i = 0; i < 3; ++i) {
        LoudnessMeter meter;
        hear([&](std::span<double> left, std::span<double> right) {
            for (const std::span<double> channel : {left, right}) {
                std::ranges::transform(channel, channel.begin(),
                                       [full_scale](double x) { return x / full_scale; });
            }
            meter.add(left, right);
        });
        peak_ = meter.true_peak() * full_scale;
        const bool is_second = level.has_value();
        if (std::isfinite(meter.integrated())) {
            level = rounded(level_of(full_scale) + meter.integrated() - *scene_.loudness);
            full_scale = pressure_of(*level);
        } else if (i == 0 && peak_ > 0) {
            full_scale = pressure_of(level_for_peak(peak_));
        } else {
            break;
        }
        if (is_second) {
            break;
        }
    }
    return level;
}

Trial GainSearch::trial_at(double level) {
    FilmSound sound(mix_, {.full_scale = pressure_of(level), .limits = true});
    sound.read_rest({[this](double part) { report(part); }, context_.stop});
    ++passes_;
    return {level, sound.levels().loudness, sound.levels().limited};
}

/// The limiter takes loudness away, and the more of it, the louder the film. So the level is
/// lowered from `start`, at most to `lowest`, until the loudness is reached, and then searched
/// between the nearest trials on both sides.
Trial GainSearch::nearest(double start, double lowest) {
    const double wanted = *scene_.loudness;
    std::optional<Trial> quieter;
    std::optional<Trial> louder;
    Trial best;
    double level = std::max(start, lowest);
    double gain_per_loudness = 1;
    for (int pass = 0; pass < kMaxPasses; ++pass) {
        const Trial trial = trial_at(level);
        if (std::abs(trial.loudness - wanted) < std::abs(best.loudness - wanted)) {
            best = trial;
        }
        if (std::abs(trial.loudness - wanted) <= kNearEnough ||
            (trial.loudness < wanted && level <= lowest)) {
            break;
        }
        if (trial.loudness < wanted) {
            if (quieter && trial.loudness > quieter->loudness) {
                gain_per_loudness = std::clamp(
                    (quieter->level - level) / (trial.loudness - quieter->loudness), 1.0, 4.0);
            }
            quieter = trial;
        } else {
            louder = trial;
        }
        if (quieter && louder) {
            const double part =
                (wanted - quieter->loudness) / (louder->loudness - quieter->loudness);
            level = quieter->level + std::clamp(part, 0.1, 0.9) * (louder->level - quieter->level);
        } else {
            level += gain_per_loudness * (trial.loudness - wanted);
        }
        level = std::max(rounded(level), lowest);
    }
    return best;
}

FilmGain GainSearch::with_loudness(double added) {
    FilmGain gain{.added = added, .limits = true, .found = FoundLoudness{}};
    const std::optional<double> start = level_without_limiter();
    if (!start) {
        gain.limits = false;  // it gets the gain for its peak
        gain.found->loudness = -std::numeric_limits<double>::infinity();
        gain.full_scale = std::max(kMinFullScale, pressure_of(rounded(level_for_peak(peak_))));
        return gain;
    }
    const Trial found = nearest(*start, rounded(level_for_peak(peak_) - kMaxLimited));
    gain.full_scale = pressure_of(found.level);
    gain.found = {.loudness = found.loudness, .limited = found.limited};
    if (found.limited > kGentlyLimited) {
        gain.found->gentle = trial_at(rounded(level_for_peak(peak_) - kGentlyLimited)).loudness;
    }
    return gain;
}

}  // namespace

FilmGain find_gain(const std::shared_ptr<FilmMix>& mix, const AddedSound& added,
                   const WorkContext& context) {
    const SoundScene& scene = mix->scene();
    GainSearch search(mix, context);
    const auto full_scale_for_peak = [&search] {
        const double peak = search.peak() / factor_of(kHighestTruePeak);
        return peak > kMinFullScale ? pressure_of(rounded(level_of(peak))) : kMinFullScale;
    };
    FilmGain gain;
    if (scene.full_scale) {
        gain = {.full_scale = *scene.full_scale, .added = *scene.full_scale, .limits = true};
    } else if (added || !scene.loudness) {
        gain.added = gain.full_scale = full_scale_for_peak();
    }
    mix->add(added, gain.added);
    if (scene.loudness) {
        gain = search.with_loudness(gain.added);
    } else if (added && !scene.full_scale) {
        gain.full_scale = std::max(gain.full_scale, full_scale_for_peak());
    }
    if (context.progress) {
        context.progress(1);
    }
    return gain;
}

}  // namespace carom::sound
