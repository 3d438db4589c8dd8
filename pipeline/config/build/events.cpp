#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>

#include "pipeline/config/build/builder.h"
#include "pipeline/config/show_quantity.h"

namespace carom::pipeline::config {

void build_stick(Builder& builder) {
    const std::optional<StickSection>& section = builder.file.stick;
    ShownStick& stick = builder.shot.stick;
    const bool is_shown = section && section->is_shown;
    for (std::size_t i = 0; i < builder.file.events.size(); ++i) {
        const EventSection& event = builder.file.events[i];
        if (std::holds_alternative<sim::Strike>(event.event.action) &&
            event.shows_stick.value_or(is_shown)) {
            stick.events.push_back(i);
        }
    }
    if (stick.events.empty()) {
        return;
    }
    const sim::billiards::TableKind kind =
        builder.file.table ? builder.file.table->kind : sim::billiards::TableKind::pool;
    const double tip = kind == sim::billiards::TableKind::snooker ? 0.0095
                       : kind == sim::billiards::TableKind::carom ? 0.0115
                                                                  : stick.tip_diameter;
    stick.tip_diameter = section && section->tip ? *section->tip : tip;
    stick.length = section ? section->length : stick.length;
    add_stick(builder.shot.scene, stick);
}

namespace {

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
