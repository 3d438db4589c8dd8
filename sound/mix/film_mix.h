// All sounds of a film in pascals, without its gain.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sound/mix/crossings.h"
#include "sound/mix/hearing.h"
#include "sound/mix/shot_mix.h"
#include "sound/sound_scene.h"

namespace carom::sound {

class FilmMix {
  public:
    /// `scene` must outlive it and not change. `only`: of this group alone.
    explicit FilmMix(const SoundScene& scene, std::optional<Group> only = std::nullopt);

    /// Adds the next kBlock samples to both channels, Pa. It does not end with the film: what rings
    /// then goes on.
    void add_block(std::span<double> left, std::span<double> right);

  private:
    void start_voices();

    const SoundScene& scene_;
    std::optional<Group> only_;
    Hearing hearing_;
    Crossings crossings_;
    double look_ahead_ = 0;   // s, by which mirrored sounds may begin before their instant
    std::int64_t block_ = 0;  // the first sample of the next block
    std::vector<ShotMix> shots_;
};

}  // namespace carom::sound
