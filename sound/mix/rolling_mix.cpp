#include "sound/mix/rolling_mix.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "core/vector_clones.h"
#include "sound/level/decibels.h"
#include "sound/space/head.h"

namespace carom::sound {
namespace {

constexpr double kCrossing = 0.005;      // s, in which passages cross over
constexpr double kNearestRolling = 0.1;  // m
constexpr std::size_t kHistory = 8192;   // samples, 58 m
constexpr int kBlocksBefore = 2;         // read out before a passage, for the way to the listener

// What delays both ears if the way takes no time, so that neither hears the future.
constexpr double kHeadDelay = kHeadRadius / kSpeedOfSound;  // s

double film_time_of_sample(std::int64_t sample) {
    return static_cast<double>(sample) / kSampleRate;
}

/// The share of a passage at a film time, which falls from 1 to 0 around its ends.
double share_at(const Passage& passage, double film_time) {
    const double begins = std::clamp((film_time - passage.from) / kCrossing + 0.5, 0.0, 1.0);
    const double ends = std::clamp((passage.to - film_time) / kCrossing + 0.5, 0.0, 1.0);
    return begins * ends;
}

/// A source at the edge of a block.
struct Edge {
    double gain = 0;  // of the pressure at 1 m, without distance
    double distance = 1;
    Ears ears;
    double left_delay = 0;  // samples
    double right_delay = 0;
};

struct SourceState {
    explicit SourceState(RollingSource rolling) : source(std::move(rolling)), history(kHistory) {}

    RollingSource source;
    std::vector<double> history;  // the pressure at 1 m, a ring by the film's sample
    Edge edge;                    // at the beginning of the next block
    bool has_edge = false;
    std::size_t silent_for = kHistory;  // samples
};

std::size_t place_in_history(std::int64_t sample) {
    static_assert((kHistory & (kHistory - 1)) == 0);
    return static_cast<std::size_t>(sample) & (kHistory - 1);
}

double between(double begin, double end, double part) {
    return begin + (end - begin) * part;
}

using BlockSamples = std::array<double, kBlock + 1>;  // the first is before the block

/// The first half of the ear's filter on samples between those of the history.
CAROM_VECTOR_CLONES void add_ear(std::span<const double> history, std::int64_t block,
                                 const Ear& begin, const Ear& end, double begin_delay,
                                 double end_delay, double begin_gain, double end_gain,
                                 BlockSamples& samples) {
    for (std::size_t n = 0; n < kBlock; ++n) {
        const double part = static_cast<double>(n) / kBlock;
        const double delay = between(begin_delay, end_delay, part);
        const double whole = std::ceil(delay);
        const double later = whole - delay;  // of a sample, in [0, 1)
        const std::int64_t at =
            block + static_cast<std::int64_t>(n) - static_cast<std::int64_t>(whole);
        const double here = history[place_in_history(at)];
        const double now =
            later > 0 ? between(here, history[place_in_history(at + 1)], later) : here;
        const double before = between(history[place_in_history(at - 1)], here, later);
        samples[n + 1] +=
            between(begin_gain, end_gain, part) *
            (between(begin.b0, end.b0, part) * now + between(begin.b1, end.b1, part) * before);
    }
}

}  // namespace

/// One passage with sources of its own.
class RollingMix::PassageRolling {
  public:
    PassageRolling(const Passage& passage, std::vector<RollingSource> sources) : passage_(passage) {
        for (RollingSource& source : sources) {
            source.begin();
            states_.emplace_back(std::move(source));
        }
    }

    [[nodiscard]] const Passage& passage() const { return passage_; }

    /// Gives the sources back.
    [[nodiscard]] std::vector<RollingSource> release() {
        std::vector<RollingSource> sources;
        for (SourceState& state : states_) {
            sources.push_back(std::move(state.source));
        }
        return sources;
    }

    void add_block(std::int64_t block, const BusMaker& bus) {
        constexpr auto kSamples = static_cast<std::int64_t>(kBlock);
        if (!is_begun_) {
            is_begun_ = true;
            for (int i = kBlocksBefore; i > 0; --i) {
                read_out(block - i * kSamples);
            }
        }
        read_out(block);
        left_.fill(0);
        right_.fill(0);
        room_.fill(0);
        bool is_audible = false;
        for (SourceState& state : states_) {
            if (state.silent_for < kHistory) {
                mix(state, block);
                is_audible = true;
            } else {
                state.has_edge = false;
            }
        }
        if (!is_audible) {
            return;
        }
        const bool is_filtered = passage_.settings.stereo == Stereo::sphere;
        ShotBus& made = bus();
        made.add({BusInput::To::left, false, is_filtered, 1, 0, 0}, left_);
        made.add({BusInput::To::right, false, is_filtered, 1, 0, 0}, right_);
        made.add({BusInput::To::room, false, false, 1, 0, 0}, room_);
    }

  private:
    /// The sources' pressures at 1 m.
    void read_out(std::int64_t block) {
        const auto end = block + static_cast<std::int64_t>(kBlock);
        const double from = passage_.scene_time(film_time_of_sample(block));
        const double to = passage_.scene_time(film_time_of_sample(end));
        std::optional<PassageBlock> shown;  // made only if something sounds
        for (SourceState& state : states_) {
            std::array<double, kBlock> pressure{};
            if (from != to && state.source.sounds(from, to)) {  // nothing rolls in a still picture
                if (!shown) {
                    shown.emplace(passage_, block, kBlock);
                }
                state.source.add(*shown, pressure);
                state.silent_for = 0;
            } else {
                state.silent_for = std::min(state.silent_for + kBlock, kHistory);
            }
            for (std::size_t n = 0; n < kBlock; ++n) {
                state.history[place_in_history(block + static_cast<std::int64_t>(n))] = pressure[n];
            }
        }
    }

    [[nodiscard]] Edge edge_at(const SourceState& state, std::int64_t sample) const {
        const PassageSettings& settings = passage_.settings;
        const double film_time = film_time_of_sample(sample);
        const double scene_time = passage_.scene_time(film_time);
        const Vec3 place = state.source.place(scene_time);
        const Listener listener = passage_.listener(film_time);
        Edge edge;
        edge.distance = std::max((place - listener.position).length(), kNearestRolling);
        edge.gain =
            factor_of(settings.gain + settings.mix[static_cast<std::size_t>(Group::rolling)]) *
            passage_.weight(film_time) * share_at(passage_, film_time);
        edge.ears = ears_of(settings.stereo, settings.width, listener, place);
        const double way = settings.has_delay ? edge.distance / kSpeedOfSound : kHeadDelay;
        const auto delay = [way](const Ear& ear) {
            constexpr double kMost = kHistory - 2 * kBlock;
            return std::clamp((way + ear.delay) * kSampleRate, 0.0, kMost);
        };
        edge.left_delay = delay(edge.ears.left);
        edge.right_delay = delay(edge.ears.right);
        return edge;
    }

    void mix(SourceState& state, std::int64_t block) {
        const Edge begin = state.has_edge ? state.edge : edge_at(state, block);
        const Edge end = edge_at(state, block + static_cast<std::int64_t>(kBlock));
        state.edge = end;
        state.has_edge = true;
        add_ear(state.history, block, begin.ears.left, end.ears.left, begin.left_delay,
                end.left_delay, begin.gain / begin.distance, end.gain / end.distance, left_);
        add_ear(state.history, block, begin.ears.right, end.ears.right, begin.right_delay,
                end.right_delay, begin.gain / begin.distance, end.gain / end.distance, right_);
        for (std::size_t n = 0; n < kBlock; ++n) {
            const double part = static_cast<double>(n) / kBlock;
            room_[n + 1] += between(begin.gain, end.gain, part) *
                            state.history[place_in_history(block + static_cast<std::int64_t>(n))];
        }
    }

    const Passage& passage_;
    std::vector<SourceState> states_;
    bool is_begun_ = false;
    BlockSamples left_{}, right_{}, room_{};
};

RollingMix::RollingMix(const SoundShot& shot, bool is_on) : shot_(&shot), is_on_(is_on) {}
RollingMix::~RollingMix() = default;
RollingMix::RollingMix(RollingMix&&) noexcept = default;
RollingMix& RollingMix::operator=(RollingMix&&) noexcept = default;

bool RollingMix::sounds(std::int64_t block) const {
    const double end = film_time_of_sample(block + static_cast<std::int64_t>(kBlock));
    return is_on_ && (!open_.empty() || (next_passage_ < shot_->passages.size() &&
                                         shot_->passages[next_passage_].from - kCrossing < end));
}

void RollingMix::add_block(std::int64_t block, const BusMaker& bus) {
    const double begin = film_time_of_sample(block);
    const double end = film_time_of_sample(block + static_cast<std::int64_t>(kBlock));
    while (next_passage_ < shot_->passages.size() &&
           shot_->passages[next_passage_].from - kCrossing < end) {
        if (unused_.empty()) {
            unused_.push_back(rolling_sources(*shot_));
        }
        open_.push_back(std::make_unique<PassageRolling>(shot_->passages[next_passage_],
                                                         std::move(unused_.back())));
        unused_.pop_back();
        ++next_passage_;
    }
    for (const auto& passage : open_) {
        passage->add_block(block, bus);
    }
    std::erase_if(open_, [&](const std::unique_ptr<PassageRolling>& passage) {
        if (passage->passage().to + kCrossing > begin) {
            return false;
        }
        unused_.push_back(passage->release());
        return true;
    });
}

}  // namespace carom::sound
