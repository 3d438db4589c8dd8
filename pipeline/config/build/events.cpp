#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "pipeline/config/build/builder.h"
#include "pipeline/config/pocket_names.h"
#include "pipeline/config/show_quantity.h"
#include "sim/billiards/layout.h"

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

/// The middle of a pocket; NaN if the table has none of that name.
Vec2 place_of_pocket(const Builder& builder, const std::string& name) {
    const auto& table = builder.shot.world.table;
    const std::string own = table ? pocket_of_name(*table, name) : std::string();
    if (!own.empty()) {
        const double radius = measures_of_set(builder.file).radius;
        for (const auto& layout : sim::billiards::make_layout(*table, radius).pockets) {
            if (layout.pocket.name == own) {
                return layout.pocket.centre;
            }
        }
    }
    return Vec2(std::numeric_limits<double>::quiet_NaN());
}

/// The target is a spot or pocket of the table; check_references reports a name that is none.
void aim_at_table(sim::Strike& strike, const Builder& builder) {
    Vec2 place = place_of_spot(builder, *strike.toward);
    if (!std::isfinite(place.x)) {
        place = place_of_pocket(builder, *strike.toward);
    }
    if (std::isfinite(place.x)) {
        strike.toward.reset();
        strike.toward_point = Vec3(place.x, place.y, 0);
    }
}

/// The direction of the strike is found when the world is complete.
void note_aim(sim::Strike& strike, const sim::Aim& aim, Builder& builder) {
    strike.direction = 0;
    const auto& table = builder.shot.world.table;
    sim::AimedStrike aimed{builder.shot.world.events.size(), aim};
    if (auto* pot = std::get_if<sim::PotAim>(&aimed.aim); pot != nullptr && table) {
        pot->pocket = pocket_of_name(*table, pot->pocket);
    }
    builder.aims.push_back(std::move(aimed));
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
                aim_at_table(*strike, builder);
            }
            if (section.aim) {
                note_aim(*strike, *section.aim, builder);
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

void aim_strikes(Builder& builder, std::size_t last_event) {
    const auto later =
        std::stable_partition(builder.aims.begin(), builder.aims.end(),
                              [&](const sim::AimedStrike& aim) { return aim.event <= last_event; });
    const std::vector<sim::AimedStrike> aims(builder.aims.begin(), later);
    builder.aims.erase(builder.aims.begin(), later);
    if (aims.empty() || builder.reader.has_error()) {
        return;
    }
    const sim::FoundAims found = sim::find_aims(builder.shot.world, aims);
    for (const Diagnostic& problem : found.problems) {
        builder.report(problem);
    }
    for (const sim::FoundDirection& direction : found.directions) {
        auto& strike = std::get<sim::Strike>(builder.shot.world.events[direction.event].action);
        strike.direction = direction.radians();
        builder.shot.found_directions.push_back(direction);
    }
}

}  // namespace carom::pipeline::config
