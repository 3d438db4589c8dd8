// What rolls and slides in one shot, as its passages hear it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "sound/mix/shot_bus.h"
#include "sound/rolling/rolling_source.h"
#include "sound/sound_scene.h"

namespace carom::sound {

/// Distance and direction are those at the edges of each block, and straight lines between them.
/// The dynamics are those of the sources, wherever they are heard from. Where one passage follows
/// another, both cross over within 5 ms. Rolling has no single reflections: it is noise, to which
/// they add nothing that the reverberation does not.
class RollingMix {
  public:
    /// `shot` must outlive it and not change. `is_on`: whether there is any.
    RollingMix(const SoundShot& shot, bool is_on);
    ~RollingMix();
    RollingMix(RollingMix&&) noexcept;
    RollingMix& operator=(RollingMix&&) noexcept;
    RollingMix(const RollingMix&) = delete;
    RollingMix& operator=(const RollingMix&) = delete;

    /// Whether a passage is shown in the block that begins with this sample.
    [[nodiscard]] bool sounds(std::int64_t block) const;

    /// Returns the bus, which it makes if there is none.
    using BusMaker = std::function<ShotBus&()>;

    /// Adds a block; in order of time. Asks for the bus only if something is heard.
    void add_block(std::int64_t block, const BusMaker& bus);

  private:
    class PassageRolling;

    const SoundShot* shot_;
    bool is_on_;
    std::vector<std::vector<RollingSource>> unused_;  // sets of sources that no passage uses now
    std::vector<std::unique_ptr<PassageRolling>> open_;
    std::size_t next_passage_ = 0;
};

}  // namespace carom::sound
