// The sounds of one shot of a film, in pascals.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sound/mix/auralisation.h"
#include "sound/mix/rolling_mix.h"
#include "sound/mix/shot_bus.h"
#include "sound/mix/voice.h"
#include "sound/rolling/rolling_source.h"
#include "sound/sound_scene.h"

namespace carom::sound {

/// It keeps nothing while it is silent.
class ShotMix {
  public:
    /// `shot` must outlive it and not change. `rolls`: with what rolls.
    ShotMix(const SoundShot& shot, bool rolls);

    /// Adds an impact; in the order in which impacts are summed.
    void start(const AuralisedImpact& heard);

    /// Adds the block of kBlock samples that begins with `block` of the film, in order of time.
    void add_block(std::int64_t block, std::span<double> left, std::span<double> right);

  private:
    void add_rolling(std::int64_t block, std::int64_t end);
    ShotBus& bus();

    const SoundShot& shot_;
    bool rolls_;
    std::vector<Voice> voices_;
    std::optional<std::vector<RollingSource>> sources_;  // made for the first clip
    std::list<RollingMix> rolling_;                      // of the clips that are shown now
    std::size_t next_clip_ = 0;
    std::unique_ptr<ShotBus> bus_;  // only while something is heard
};

}  // namespace carom::sound
