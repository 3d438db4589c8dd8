#include <algorithm>
#include <cmath>
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

/// The target is a spot of the table; check_references reports a name that is none.
void aim_at_spot(sim::Strike& strike, const Builder& builder) {
    const Vec2 spot = place_of_spot(builder, *strike.toward);
    if (std::isfinite(spot.x)) {
        strike.toward.reset();
        strike.toward_point = Vec3(spot.x, spot.y, 0);
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
            } else if (strike->toward && !builder.placed.contains(*strike->toward)) {
                aim_at_spot(*strike, builder);
            }
        }
        if (auto* place = std::get_if<sim::PlaceBall>(&event.action);
            place != nullptr && !place->spot.empty()) {
            place->at = place_of_spot(builder, place->spot);
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
