// When something moves in contact, from the event log of a timeline.
#pragma once

#include <span>
#include <vector>

#include "sim/timeline/timeline.h"
#include "sound/sound_scene.h"

namespace carom::sound {

/// A time (scene s, from < to) of lasting contact.
struct Stretch {
    double from = 0;
    double to = 0;

    bool operator==(const Stretch&) const = default;
};

/// For each body, when it rolls or slides as a ball, in order of time and without overlaps: from
/// when the log has it sliding or rolling until it has it resting, spinning in place, airborne,
/// potted, off the table, taken away or put somewhere, or until the timeline ends. A ball that has
/// moved horizontally, and not vertically, before its first state in the log has been on the cloth
/// from the beginning. Bodies that are no balls, or have no track, have none.
[[nodiscard]] std::vector<std::vector<Stretch>> rolling_stretches(
    const sim::Timeline& timeline, std::span<const SoundBody> bodies);

}  // namespace carom::sound
