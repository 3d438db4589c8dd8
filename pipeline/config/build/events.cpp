#include <algorithm>
#include <utility>
#include <variant>

#include "pipeline/config/build/builder.h"
#include "pipeline/config/show_quantity.h"

namespace carom::pipeline::config {

namespace {

/// Moves the object of a contact to the first place; the two names may be given in any order.
void order_contact(sim::ForceEvent& event, const Place& place, Builder& builder) {
    if (!event.trigger || event.trigger->kind != sim::Trigger::Kind::contact) {
        return;
    }
    const std::vector<std::string>& surfaces = surface_names();
    const auto is_surface = [&](const std::string& name) {
        return std::find(surfaces.begin(), surfaces.end(), name) != surfaces.end();
    };
    sim::Trigger& trigger = *event.trigger;
    if (is_surface(trigger.a)) {
        std::swap(trigger.a, trigger.b);
    }
    if (is_surface(trigger.a)) {
        builder.reader.error(place, "this event waits for '" + trigger.b + "' to touch '" +
                                        trigger.a + "'; one of them must be an object");
    }
}

}  // namespace

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
        order_contact(event, section.place, builder);
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
