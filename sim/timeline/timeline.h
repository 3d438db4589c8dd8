// Everything a simulation found out, ready to be filmed, exported or reported.
#pragma once

#include <string_view>
#include <vector>

#include "sim/timeline/event.h"
#include "sim/timeline/track.h"

namespace carom::sim {

struct Timeline {
    double start_time = 0;             // scene time of the first state, s
    double end_time = 0;               // and of the last
    std::vector<Track> tracks;         // one per moving object, in the order of the world
    std::vector<Event> events;         // in order of time
    std::vector<EnergySample> energy;  // in order of time

    /// The track of that name, or nullptr.
    [[nodiscard]] const Track* find(std::string_view name) const;

    bool operator==(const Timeline&) const = default;
};

}  // namespace carom::sim
