#include <variant>

#include "pipeline/config/build/builder.h"
#include "pipeline/config/units.h"

namespace carom::pipeline::config {

void build_events(Builder& builder) {
    for (const EventSection& section : builder.file.events) {
        sim::ForceEvent event = section.event;
        if (auto* strike = std::get_if<sim::Strike>(&event.action); strike != nullptr) {
            // The simulation knows nothing of what is only seen: such a thing is a point to it.
            const auto seen =
                strike->toward ? builder.scenery.find(*strike->toward) : builder.scenery.end();
            if (seen != builder.scenery.end()) {
                strike->toward.reset();
                strike->toward_point = seen->second;
            }
        }
        const double start = event.time + event.after;
        if (start > builder.shot.world.duration) {
            builder.reader.warning(section.place,
                                   "this event starts at " + show(start, Dimension::time) +
                                       ", after the simulation's end at " +
                                       show(builder.shot.world.duration, Dimension::time));
        }
        builder.shot.world.events.push_back(std::move(event));
    }
}

}  // namespace carom::pipeline::config
