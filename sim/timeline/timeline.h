// The results of a simulation, for rendering, export and reports.
#pragma once

#include <string_view>
#include <vector>

#include "core/diagnostic.h"
#include "sim/timeline/event.h"
#include "sim/timeline/track.h"

namespace carom::sim {

struct Timeline {
    double start_time = 0;             // scene time of the first state, s
    double end_time = 0;               // scene time of the last state, s
    std::vector<Track> tracks;         // one per moving object, in the order of the world
    std::vector<Event> events;         // in order of time
    std::vector<EnergySample> energy;  // in order of time
    std::vector<LastingContact> lasting_contacts;  // in order of their start times
    std::vector<PutBack> put_backs;                // in order of time
    std::vector<Diagnostic> warnings;  // a strike that misses, a miscue, a trigger never met ...

    /// The track of that name, or nullptr.
    [[nodiscard]] const Track* find(std::string_view name) const;

    bool operator==(const Timeline&) const = default;
};

}  // namespace carom::sim
