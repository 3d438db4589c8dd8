#include "sound/mix/rolling_mix.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "core/vector_clones.h"
#include "sound/level/decibels.h"

namespace carom::sound {
namespace {

constexpr double kCrossing = 0.005;      // s, in which clips cross over
constexpr double kNearestRolling = 0.1;  // m
constexpr std::size_t kHistory = 8192;   // samples, 58 m
constexpr int kBlocksBefore = 2;         // played before a clip, for the delay to the listener

// What delays both ears if the sound takes no time, so that neither hears the future.
constexpr double kHeadDelay = kHeadRadius / kSpeedOfSound;  // s

/// The gain of a clip at a film time, which falls from 1 to 0 around its ends.
double cross_fade_gain(const Clip& clip, double film_time) {
    const double begins = std::clamp((film_time - clip.from) / kCrossing + 0.5, 0.0, 1.0);
    const double ends = std::clamp((clip.to - film_time) / kCrossing + 0.5, 0.0, 1.0);
    return begins * ends;
}

std::size_t place_in_history(std::int64_t sample) {
    static_assert((kHistory & (kHistory - 1)) == 0);
    return static_cast<std::size_t>(sample) & (kHistory - 1);
}

double between(double begin, double end, double part) {
    return begin + (end - begin) * part;
}

}  // namespace

RollingMix::Source::Source(const RollingSource& source)
    : voice(source), history(kHistory), silent_for(kHistory) {}

RollingMix::RollingMix(const Clip& clip, const std::vector<RollingSource>& sources)
    : clip_(&clip), sources_(sources.begin(), sources.end()) {}

bool RollingMix::begins_before(const Clip& clip, double film_time) {
    return clip.from - kCrossing < film_time;
}

bool RollingMix::is_heard_after(double film_time) const {
    return clip_->to + kCrossing > film_time;
}

bool RollingMix::make_block(std::int64_t block) {
    if (!is_begun_) {
        is_begun_ = true;
        for (int i = kBlocksBefore; i > 0; --i) {
            play(block - i * static_cast<std::int64_t>(kBlock));
        }
    }
    play(block);
    left_.fill(0);
    right_.fill(0);
    room_.fill(0);
    bool is_audible = false;
    for (Source& source : sources_) {
        if (source.silent_for < kHistory) {
            mix(source, block);
            is_audible = true;
        } else {
            source.edge.reset();
        }
    }
    return is_audible;
}

void RollingMix::add_to(ShotBus& bus) const {
    const bool is_filtered = clip_->settings.stereo == Stereo::sphere;
    bus.add({BusInput::To::left, false, is_filtered, 1, 0, 0}, left_);
    bus.add({BusInput::To::right, false, is_filtered, 1, 0, 0}, right_);
    bus.add({BusInput::To::room, false, false, 1, 0, 0}, room_);
}

/// Plays the block's pressures at 1 m into the histories.
void RollingMix::play(std::int64_t block) {
    const auto end = block + static_cast<std::int64_t>(kBlock);
    const double from = clip_->scene_time(time_of_sample(block));
    const double to = clip_->scene_time(time_of_sample(end));
    std::optional<ClipBlock> shown;  // made only if something sounds
    for (Source& source : sources_) {
        std::array<double, kBlock> pressure{};
        if (from != to && source.voice.source().sounds(from, to)) {  // not in a still picture
            if (!shown) {
                shown.emplace(*clip_, block, kBlock);
            }
            source.voice.add(*shown, pressure);
            source.silent_for = 0;
        } else {
            source.silent_for = std::min(source.silent_for + kBlock, kHistory);
        }
        for (std::size_t n = 0; n < kBlock; ++n) {
            source.history[place_in_history(block + static_cast<std::int64_t>(n))] = pressure[n];
        }
    }
}

RollingMix::Edge RollingMix::edge_at(const Source& source, std::int64_t sample) const {
    const ClipSettings& settings = clip_->settings;
    const double film_time = time_of_sample(sample);
    const Vec3 place = source.voice.source().place(clip_->scene_time(film_time));
    const Listener listener = clip_->listener(film_time);
    const double distance = std::max((place - listener.position).length(), kNearestRolling);
    const double delay = settings.has_delay ? distance / kSpeedOfSound : kHeadDelay;
    Edge edge;
    edge.gain = factor_of(settings.gain + settings.mix[static_cast<std::size_t>(Group::rolling)]) *
                clip_->weight(film_time) * cross_fade_gain(*clip_, film_time);
    const auto path_to = [&](const Ear& ear) {
        constexpr double kMost = kHistory - 2 * kBlock;
        return Edge::Path{ear, std::clamp((delay + ear.delay) * kSampleRate, 0.0, kMost),
                          edge.gain / distance};
    };
    const Ears ears = ears_of(settings.stereo, settings.width, listener, place);
    edge.left = path_to(ears.left);
    edge.right = path_to(ears.right);
    return edge;
}

/// The first half of the ear's filter on samples between those of the history.
CAROM_VECTOR_CLONES void RollingMix::add_path(std::span<const double> history, std::int64_t block,
                                              Edge::Path begin, Edge::Path end,
                                              std::span<double> samples) {
    for (std::size_t n = 0; n < kBlock; ++n) {
        const double part = static_cast<double>(n) / kBlock;
        const double delay = between(begin.delay, end.delay, part);
        const double whole = std::ceil(delay);
        const double later = whole - delay;  // of a sample, in [0, 1)
        const std::int64_t at =
            block + static_cast<std::int64_t>(n) - static_cast<std::int64_t>(whole);
        const double here = history[place_in_history(at)];
        const double now =
            later > 0 ? between(here, history[place_in_history(at + 1)], later) : here;
        const double before = between(history[place_in_history(at - 1)], here, later);
        samples[n + 1] += between(begin.gain, end.gain, part) *
                          (between(begin.ear.b0, end.ear.b0, part) * now +
                           between(begin.ear.b1, end.ear.b1, part) * before);
    }
}

void RollingMix::mix(Source& source, std::int64_t block) {
    const Edge begin = source.edge ? *source.edge : edge_at(source, block);
    const Edge end = edge_at(source, block + static_cast<std::int64_t>(kBlock));
    source.edge = end;
    add_path(source.history, block, begin.left, end.left, left_);
    add_path(source.history, block, begin.right, end.right, right_);
    for (std::size_t n = 0; n < kBlock; ++n) {
        const double part = static_cast<double>(n) / kBlock;
        room_[n + 1] += between(begin.gain, end.gain, part) *
                        source.history[place_in_history(block + static_cast<std::int64_t>(n))];
    }
}

}  // namespace carom::sound
