// What a clip of a film does during a block of samples, computed once for all that rolls.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sound/sound_scene.h"

namespace carom::sound {

/// How fast a sound plays while the film runs at `speed` (scene seconds per film second):
/// max(|speed|, lowest)^pitch, and at most 2; the default follows the picture down to an eighth.
[[nodiscard]] double playing_speed(double speed, const ClipSettings& settings);

struct ClipBlock {
    /// The samples `first` to `first` + `count` - 1 of the film, at kSampleRate. They may lie a
    /// little outside of the clip.
    ClipBlock(const Clip& clip, std::int64_t first, std::size_t count);

    std::int64_t first = 0;
    double dynamics = 1;             // ClipSettings::ratio
    std::vector<double> scene_time;  // s, of each sample
    std::vector<double> speed;       // playing_speed(); 0 where the picture stands still
    std::vector<double> ratio;       // speed / |film's speed|: 1 if the pitch follows the picture
    /// The factor with which lasting sounds are heard: 1, but below a hundredth of the normal speed
    /// it falls to 0 with the film's speed (tuned), so that they end where the picture stops,
    /// though the pitch goes no lower.
    std::vector<double> fade;
};

}  // namespace carom::sound
