#include <utility>
#include <variant>

#include "pipeline/config/build/builder.h"
#include "pipeline/config/show_quantity.h"

namespace carom::pipeline::config {

void build_events(Builder& builder) {
    for (const EventSection& section : builder.file.events) {
        sim::ForceEvent event = section.event;
        if (auto* strike = std::get_if<sim::Strike>(&event.action); strike != nullptr) {
            // The simulation does not contain objects that are only visible, so the aim is their
            // position.
            const auto visible =
                strike->toward ? builder.scenery.find(*strike->toward) : builder.scenery.end();
            if (visible != builder.scenery.end()) {
                strike->toward.reset();
                strike->toward_point = visible->second;
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
