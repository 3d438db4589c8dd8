#include "sound/mix/shot_mix.h"

#include <algorithm>

namespace carom::sound {

ShotMix::ShotMix(const SoundShot& shot, bool rolls) : shot_(shot), rolling_(shot, rolls) {}

void ShotMix::start(const Heard& heard) {
    voices_.emplace_back(heard, shot_.room);
}

ShotBus& ShotMix::bus() {
    if (!bus_) {
        const bool is_mono = std::ranges::all_of(shot_.passages, [](const Passage& passage) {
            return passage.settings.stereo == Stereo::mono;
        });
        bus_ = std::make_unique<ShotBus>(shot_.room, is_mono);
    }
    return *bus_;
}

void ShotMix::add_block(std::int64_t block, std::span<double> left, std::span<double> right) {
    const std::int64_t end = block + static_cast<std::int64_t>(kBlock);
    for (const Voice& voice : voices_) {
        if (voice.first() < end) {
            voice.add(block, bus());
        }
    }
    std::erase_if(voices_, [end](const Voice& voice) { return voice.last() <= end; });
    if (rolling_.sounds(block)) {
        rolling_.add_block(block, [this]() -> ShotBus& { return bus(); });
    }
    if (bus_) {
        bus_->take(left, right);
        if (bus_->is_silent()) {
            bus_.reset();
        }
    }
}

}  // namespace carom::sound
