#include "sound/mix/shot_mix.h"

#include <algorithm>

namespace carom::sound {

ShotMix::ShotMix(const SoundShot& shot, bool rolls) : shot_(shot), rolls_(rolls) {}

void ShotMix::start(const AuralisedImpact& heard) {
    voices_.emplace_back(heard, shot_.room);
}

ShotBus& ShotMix::bus() {
    if (!bus_) {
        const bool is_mono = std::ranges::all_of(
            shot_.clips, [](const Clip& clip) { return clip.settings.stereo == Stereo::mono; });
        bus_ = std::make_unique<ShotBus>(shot_.room, is_mono);
    }
    return *bus_;
}

void ShotMix::add_rolling(std::int64_t block, std::int64_t end) {
    const std::vector<Clip>& clips = shot_.clips;
    for (; next_clip_ < clips.size() &&
           RollingMix::begins_before(clips[next_clip_], time_of_sample(end));
         ++next_clip_) {
        if (!sources_) {
            sources_ = rolling_sources(shot_);
        }
        rolling_.emplace_back(clips[next_clip_], *sources_);
    }
    for (RollingMix& rolling : rolling_) {
        if (rolling.make_block(block)) {
            rolling.add_to(bus());
        }
    }
    std::erase_if(rolling_, [&](const RollingMix& rolling) {
        return !rolling.is_heard_after(time_of_sample(block));
    });
}

void ShotMix::add_block(std::int64_t block, std::span<double> left, std::span<double> right) {
    const std::int64_t end = block + static_cast<std::int64_t>(kBlock);
    for (const Voice& voice : voices_) {
        if (voice.first() < end) {
            voice.add(block, bus());
        }
    }
    std::erase_if(voices_, [end](const Voice& voice) { return voice.last() <= end; });
    if (rolls_) {
        add_rolling(block, end);
    }
    if (bus_) {
        bus_->take(left, right);
        if (bus_->is_silent()) {
            bus_.reset();
        }
    }
}

}  // namespace carom::sound
