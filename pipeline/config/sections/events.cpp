#include <array>
#include <numbers>

#include "pipeline/config/sections/occurrences.h"
#include "pipeline/config/sections/sections.h"
#include "sim/limits.h"

namespace carom::pipeline::config {

namespace {

using sim::ForceEvent;
using sim::Strike;

constexpr double kLongest = 3600;  // s

/// A strike with what its keys say beside the event.
struct StrikeSection : ForceEvent {
    std::optional<std::string> pot, in, of, hit;
    std::optional<double> cut;
    double fullness = 1;
    std::optional<sim::Side> side;
    std::optional<Vec2> through;
    std::optional<bool> shows_stick;
};

/// Adds the keys for the time of an event, which all kinds have.
template <class Event>
void add_start(MapSpec<Event>& s) {
    s.key("at", &Event::time, time(between(0, kLongest)),
          "scene time. With `when`, the event does not happen before it");
    s.set(
        "when", condition(),
        [](ForceEvent& event, sim::EventTime condition) {
            event.trigger = std::move(condition.trigger);
            event.after += condition.delay;
        },
        "condition that starts the event when it becomes true for the first time, or the `nth`");
    const auto delay = time(between(0, kLongest));
    s.set(
        "after", delay, [](ForceEvent& event, double later) { event.after += later; },
        "delay after `at` or `when`", delay.show(0));
}

template <class Action>
MapSpec<ForceEvent> event_of(std::string_view name, std::string_view description) {
    ForceEvent prototype;
    prototype.action.emplace<Action>();
    return {name, description, prototype};
}

void add_object(MapSpec<ForceEvent>& s) {
    s.key("object", &ForceEvent::object, name_of(ReferenceKind::body), "the ball or object")
        .required();
}

template <class Action>
void add_point_and_axes(MapSpec<ForceEvent>& s) {
    s.key(
        "at_point", [](ForceEvent& e) -> Vec3& { return std::get<Action>(e.action).at_point; },
        vector3(Dimension::length),
        "point where it acts, relative to the centre of mass, in `axes`");
    s.key(
        "axes", [](ForceEvent& e) -> sim::Axes& { return std::get<Action>(e.action).axes; },
        choice<sim::Axes>({{"world", sim::Axes::world}, {"body", sim::Axes::body}}),
        "axes of the vectors; `body`: axes that rotate with the object");
}

const MapSpec<ForceEvent>& force_spec() {
    static const MapSpec<ForceEvent> spec = [] {
        MapSpec<ForceEvent> s = event_of<sim::Force>("force", "A force that acts for some time.");
        add_object(s);
        add_start(s);
        s.key(
             "for",
             [](ForceEvent& e) -> double& { return std::get<sim::Force>(e.action).duration; },
             time(above_up_to(0, kLongest)), "duration for which it acts")
            .required();
        s.key(
             "newtons",
             [](ForceEvent& e) -> Vec3& { return std::get<sim::Force>(e.action).newtons; },
             vector3(Dimension::force, between(-sim::kMaxForce, sim::kMaxForce)), "the force")
            .required();
        add_point_and_axes<sim::Force>(s);
        return s;
    }();
    return spec;
}

const MapSpec<ForceEvent>& torque_spec() {
    static const MapSpec<ForceEvent> spec = [] {
        MapSpec<ForceEvent> s =
            event_of<sim::Torque>("torque", "A torque that acts for some time.");
        using sim::Torque;
        add_object(s);
        add_start(s);
        s.key(
             "for", [](ForceEvent& e) -> double& { return std::get<Torque>(e.action).duration; },
             time(above_up_to(0, kLongest)), "duration for which it acts")
            .required();
        s.key(
             "newton_metres",
             [](ForceEvent& e) -> Vec3& { return std::get<Torque>(e.action).newton_metres; },
             vector3(Dimension::torque, between(-sim::kMaxTorque, sim::kMaxTorque)), "the torque")
            .required();
        s.key(
            "axes", [](ForceEvent& e) -> sim::Axes& { return std::get<Torque>(e.action).axes; },
            choice<sim::Axes>({{"world", sim::Axes::world}, {"body", sim::Axes::body}}),
            "axes of the vectors; `body`: axes that rotate with the object");
        return s;
    }();
    return spec;
}

const MapSpec<ForceEvent>& impulse_spec() {
    static const MapSpec<ForceEvent> spec = [] {
        MapSpec<ForceEvent> s = event_of<sim::Impulse>("impulse", "An instantaneous impulse.");
        add_object(s);
        add_start(s);
        s.key(
             "newton_seconds",
             [](ForceEvent& e) -> Vec3& { return std::get<sim::Impulse>(e.action).newton_seconds; },
             vector3(Dimension::impulse, between(-sim::kMaxImpulse, sim::kMaxImpulse)),
             "the impulse")
            .required();
        add_point_and_axes<sim::Impulse>(s);
        return s;
    }();
    return spec;
}

const MapSpec<ForceEvent>& velocity_spec() {
    static const MapSpec<ForceEvent> spec = [] {
        MapSpec<ForceEvent> s =
            event_of<sim::SetVelocity>("velocity", "Sets an object's velocity.");
        using sim::SetVelocity;
        add_object(s);
        add_start(s);
        s.key(
            "linear",
            [](ForceEvent& e) -> std::optional<Vec3>& {
                return std::get<SetVelocity>(e.action).linear;
            },
            vector3(Dimension::speed, between(-sim::kMaxSpeed, sim::kMaxSpeed)),
            "velocity in world axes. By default it is left unchanged");
        s.key(
            "angular",
            [](ForceEvent& e) -> std::optional<Vec3>& {
                return std::get<SetVelocity>(e.action).angular;
            },
            vector3(Dimension::angular_speed, between(-sim::kMaxSpin, sim::kMaxSpin)),
            "angular velocity in world axes. By default it is left unchanged");
        s.check([](Reader& reader, const Node& node, ForceEvent&) {
            if (node.find("linear") == nullptr && node.find("angular") == nullptr) {
                reader.error(reader.key_place(),
                             reader.label() + " needs 'linear' or 'angular' or both");
            }
        });
        return s;
    }();
    return spec;
}

Strike& strike_of(ForceEvent& event) {
    return std::get<Strike>(event.action);
}

/// Adds the target of a strike: the name of an object, spot or pocket, or a point.
void add_toward(MapSpec<StrikeSection>& s) {
    const auto by_name = convert<Strike>(name_of(ReferenceKind::aimed), [](std::string name) {
        Strike strike;
        strike.toward = std::move(name);
        return strike;
    });
    const auto by_point =
        convert<Strike>(coordinates(Dimension::length), [](const Coordinates& point) {
            Strike strike;
            strike.toward_point = point.value;
            return strike;
        });
    s.set(
        "toward", any_of<Strike>({{is_scalar, by_name}, {is_list, by_point}}),
        [](ForceEvent& event, const Strike& aim) {
            strike_of(event).toward = aim.toward;
            strike_of(event).toward_point = aim.toward_point;
        },
        "target of the aim: the centre of an object at that moment, a spot or pocket of the table, "
        "or a point. An object comes before a spot of the same name");
}

/// A part of a ball: a number, or a player's word.
ValueType<double> fullness() {
    const auto is_players_word = [](const Node& node) {
        return node.is_scalar() && (node.text == "full" || node.text == "thin");
    };
    return any_of<double>({{is_players_word, choice<double>({{"full", 1}, {"thin", 1.0 / 8}})},
                           {is_number, number(above_up_to(0, 1))}});
}

/// Adds the aims that are found by simulating (sim/aim).
void add_found_aims(MapSpec<StrikeSection>& s) {
    s.key("pot", &StrikeSection::pot, name_of(ReferenceKind::ball),
          "instead of `direction`: the ball that is potted. The direction is found by simulating, "
          "with throw, squirt and swerve, as for `cut`, `hit` and `through`");
    s.key(
         "in", &StrikeSection::in, name_of(ReferenceKind::pocket),
         "the pocket: `corner_right_back`, or as it lies in the plan `top right` (docs/tables.md). "
         "By default that of the open ones for which the strike may err most")
        .goes_with({"pot"});
    s.key("cut", &StrikeSection::cut, angle(from_below(0, std::numbers::pi / 2)),
          "instead of `direction`: the angle by which the ball `of` leaves from the line on which "
          "the struck ball comes");
    s.key("of", &StrikeSection::of, name_of(ReferenceKind::ball), "the ball that is cut")
        .needed_by("cut");
    s.key("hit", &StrikeSection::hit, name_of(ReferenceKind::ball),
          "instead of `direction`: the ball that is hit, with `fullness`");
    s.key("fullness", &StrikeSection::fullness, fullness(),
          "the part of the ball `hit` that the struck ball covers, seen along its path: `1/2` is a "
          "half-ball hit, `thin` 1/8")
        .goes_with({"hit"});
    s.key("side", &StrikeSection::side,
          choice<sim::Side>({{"left", sim::Side::left}, {"right", sim::Side::right}}),
          "as seen from the struck ball: to which side the ball goes with `cut`, on which side it "
          "is touched with `hit`")
        .goes_with({"cut", "hit"});
    s.key("through", &StrikeSection::through, vector2(Dimension::length),
          "instead of `direction`: a point over which the ball's centre passes before it touches "
          "anything");
}

/// Reports an aim at the struck ball itself, and a missing side.
void check_aim(Reader& reader, const Node& node, StrikeSection& section) {
    for (const char* key : {"pot", "of", "hit"}) {
        const Entry* entry = node.find(key);
        if (entry != nullptr && entry->value.is_scalar() && entry->value.text == section.object) {
            reader.error(entry->value.place, "a ball cannot be aimed at itself");
        }
    }
    const bool needs_side = section.cut || (section.hit && section.fullness < 1);
    if (needs_side && node.find("side") == nullptr) {
        const std::string key = section.cut ? "cut" : "hit";
        reader.error(node.find(key)->key_place,
                     "'" + key + "' needs the key 'side'" +
                         (section.hit ? ", unless its 'fullness' is full" : ""));
    }
}

std::optional<sim::Aim> aim_of(const StrikeSection& section) {
    if (section.pot) {
        return sim::PotAim{*section.pot, section.in.value_or("")};
    }
    if (section.cut) {
        return sim::CutAim{section.of.value_or(""), *section.cut,
                           section.side.value_or(sim::Side::left)};
    }
    if (section.hit) {
        return sim::HitAim{*section.hit, section.fullness, section.side.value_or(sim::Side::left)};
    }
    return section.through ? std::optional<sim::Aim>(sim::ThroughAim{*section.through})
                           : std::nullopt;
}

void check_tip(Reader& reader, const Node& node, StrikeSection& event) {
    const Vec2& tip = strike_of(event).tip;
    if (tip.dot(tip) >= 1) {
        reader.error(node.find("tip")->value.place,
                     "'tip' must be less than 1 ball radius from the centre; otherwise the stick "
                     "misses the ball");
    }
}

void add_strike_keys(MapSpec<StrikeSection>& s) {
    s.key(
        "speed", [](ForceEvent& e) -> std::optional<double>& { return strike_of(e).speed; },
        quantity(Dimension::speed, above_up_to(0, 100)),
        "speed of the stick at the impact; a ball that moves away from it faster is not reached");
    s.key(
        "ball_speed",
        [](ForceEvent& e) -> std::optional<double>& { return strike_of(e).ball_speed; },
        quantity(Dimension::speed, above_up_to(0, 100)),
        "speed of the ball after the strike, however it moved before. One that touches other balls "
        "is pushed, together with them, until it has this speed");
    add_toward(s);
    s.key(
        "direction", [](ForceEvent& e) -> std::optional<double>& { return strike_of(e).direction; },
        angle(), "direction of the aim, counter-clockwise from +x");
    add_found_aims(s);
    s.key(
        "elevation", [](ForceEvent& e) -> double& { return strike_of(e).elevation; },
        angle(from_below(0, std::numbers::pi / 2)), "angle by which the stick's butt is raised");
    s.key(
        "tip", [](ForceEvent& e) -> Vec2& { return strike_of(e).tip; },
        vector2(Dimension::none, between(-1, 1)),
        "offset of the tip from the centre, to the right and up for the player, in ball radii");
    s.key(
        "stick_mass", [](ForceEvent& e) -> double& { return strike_of(e).stick_mass; },
        quantity(Dimension::mass, above_up_to(0, 10)), "mass of the whole stick");
    s.key(
        "end_mass_ratio", [](ForceEvent& e) -> double& { return strike_of(e).end_mass_ratio; },
        number(above_up_to(0, 1)),
        "effective end mass of the stick divided by the mass of the ball, which determines the "
        "squirt: 1/22 for a regular shaft, 1/30 for a low-deflection one");
    s.key(
        "tip_restitution", [](ForceEvent& e) -> double& { return strike_of(e).tip_restitution; },
        number(between(0, 1)),
        "restitution of the tip: 0.73 for leather, 0.84 for a phenolic one (Alciatore, TP B-8)");
}

const MapSpec<StrikeSection>& strike_spec() {
    static const MapSpec<StrikeSection> spec = [] {
        StrikeSection prototype;
        prototype.action.emplace<Strike>();
        MapSpec<StrikeSection> s(
            "strike", "A cue stick strikes a ball (Alciatore, TP A-30, A-31 and B-8).", prototype);
        s.key("ball", &StrikeSection::object, name_of(ReferenceKind::ball), "the ball").required();
        add_start(s);
        add_strike_keys(s);
        s.key(
            "stick", &StrikeSection::shows_stick, shown_or_hidden(),
            "whether the cue stick of this strike is seen. The default is the shot's own `stick`");
        s.exactly_one_or_solved({"speed", "ball_speed"});
        s.exactly_one_or_solved({"toward", "direction", "pot", "cut", "hit", "through"});
        s.check(check_tip);
        s.check(check_aim);
        return s;
    }();
    return spec;
}

}  // namespace

std::span<const std::string_view> aim_keys() {
    static constexpr std::array<std::string_view, 8> kKeys{"pot", "in",       "cut",  "of",
                                                           "hit", "fullness", "side", "through"};
    return kKeys;
}

void add_event_start(MapSpec<ForceEvent>& spec) {
    add_start(spec);
}

const MapSpec<EventSection>& event_spec() {
    static const MapSpec<EventSection> spec = [] {
        MapSpec<EventSection> s("event", "An action on a ball or object, and its time.");
        const auto store = [](EventSection& section, ForceEvent event) {
            section.event = std::move(event);
        };
        s.set(
            "strike", record(strike_spec()),
            [](EventSection& section, StrikeSection strike) {
                section.aim = aim_of(strike);
                section.shows_stick = strike.shows_stick;
                section.event = std::move(strike);
            },
            "a strike with a cue stick");
        s.set("impulse", record(impulse_spec()), store, "an instantaneous impulse");
        s.set("force", record(force_spec()), store, "a force that acts for some time");
        s.set("torque", record(torque_spec()), store, "a torque that acts for some time");
        s.set("velocity", record(velocity_spec()), store, "a change of velocity");
        s.set("place", record(place_spec()), store, "a ball that is put down on the table");
        s.set("remove", record(remove_spec()), store, "a ball that is taken off the table");
        s.exactly_one_of({"strike", "impulse", "force", "torque", "velocity", "place", "remove"});
        s.check([](Reader& reader, const Node& node, EventSection& section) {
            section.place = node.entries.empty() ? reader.key_place() : node.entries[0].key_place;
        });
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
