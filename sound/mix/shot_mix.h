// The sounds of one shot of a film, in pascals.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sound/mix/hearing.h"
#include "sound/mix/rolling_mix.h"
#include "sound/mix/shot_bus.h"
#include "sound/mix/voice.h"
#include "sound/sound_scene.h"

namespace carom::sound {

/// It keeps nothing while it is silent.
class ShotMix {
  public:
    /// `shot` must outlive it and not change. `rolls`: with what rolls.
    ShotMix(const SoundShot& shot, bool rolls);

    /// Adds an impact; in the order in which impacts are summed.
    void start(const Heard& heard);

    /// Adds the block of kBlock samples that begins with `block` of the film, in order of time.
    void add_block(std::int64_t block, std::span<double> left, std::span<double> right);

  private:
    ShotBus& bus();

    const SoundShot& shot_;
    std::vector<Voice> voices_;
    RollingMix rolling_;
    std::unique_ptr<ShotBus> bus_;  // only while something is heard
};

}  // namespace carom::sound
