// Moments: scene times that are named by what happens in the shot.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "sim/force_event.h"
#include "sim/timeline/timeline.h"
#include "sim/world.h"

namespace carom::sim {

/// The time of an occurrence, moved by a delay.
struct EventTime {
    Trigger trigger;
    double delay = 0;  // s after the occurrence; negative: before it
};

/// The times (s) at which the trigger's occurrence, whatever its `nth`, happens in the timeline, in
/// order. They are those at which an event of the world with this trigger happens, within the
/// errors of the timeline's keys (TrackRecorder): bodies that rest again after they moved, impacts
/// that are not the same contact (kOneContact), flights that rise by kMinRise.
[[nodiscard]] std::vector<double> find_occurrences(const Trigger& trigger, const Timeline& timeline,
                                                   const WorldDescription& world);

/// The scene time (s) of the moment, or why there is none and what happens instead, as a sentence
/// without a full stop: "'cue' never touched 'one'; it touched 'two' at 0.51 s". The time may be
/// outside the timeline because of the delay.
[[nodiscard]] std::variant<double, std::string> find_event_time(const EventTime& moment,
                                                                const Timeline& timeline,
                                                                const WorldDescription& world);

}  // namespace carom::sim
