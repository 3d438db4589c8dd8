// Actions on bodies, and the times or triggers at which they happen.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "core/vectors.h"

namespace carom::sim {

enum class Axes { world, body };

/// A force (N) during `duration`; its total impulse is exact for any step.
struct Force {
    Vec3 newtons{0, 0, 0};
    double duration = 0;     // s, > 0
    Vec3 at_point{0, 0, 0};  // from the centre of mass, in `axes`, m
    Axes axes = Axes::world;
};

/// A torque (N m) during `duration`.
struct Torque {
    Vec3 newton_metres{0, 0, 0};
    double duration = 0;  // s, > 0
    Axes axes = Axes::world;
};

/// An instantaneous impulse (N s).
struct Impulse {
    Vec3 newton_seconds{0, 0, 0};
    Vec3 at_point{0, 0, 0};
    Axes axes = Axes::world;
};

/// Sets the given velocities and keeps the others.
struct SetVelocity {
    std::optional<Vec3> linear;   // m/s, world axes
    std::optional<Vec3> angular;  // rad/s, world axes
};

/// A ball struck by a cue stick (Alciatore, TP and B-8). Exactly one of `toward` and
/// `direction` gives the aim, exactly one of `speed` and `ball_speed` the strength.
struct Strike {
    std::optional<double> speed;        // of the stick, m/s, > 0
    std::optional<double> ball_speed;   // of the ball after the strike, m/s, > 0
    std::optional<std::string> toward;  // the target object (its centre at the time of the strike)
    std::optional<Vec3> toward_point;   // or a target point, m
    std::optional<double> direction;    // or an angle counter-clockwise from +x, rad
    double elevation = 0;               // of the stick, rad, [0, pi/2)
    Vec2 tip{0, 0};             // offset to the right and up as the shooter sees it, in ball radii
    double stick_mass = 0.567;  // kg, > 0
    /// Effective end mass / ball mass, > 0 (squirt). At an offset of R/2, 1/22 gives the 2.5
    /// degrees of a regular shaft, 1/30 the 1.8 degrees of a low-deflection shaft (quoted from
    /// Alciatore).
    double end_mass_ratio = 1.0 / 22;
    /// Of the tip, [0, 1]: 0.71 to 0.75 leather, 0.81 to 0.87 phenolic (Alciatore, TP B-8).
    double tip_restitution = 0.73;
};

/// A ball is put down at rest on the cloth, wherever it is and however it moves.
struct PlaceBall {
    Vec2 at{0, 0};     // its centre, seen from above, m
    std::string spot;  // the name of the spot there; empty: none
    /// What happens while another ball or object is in the way.
    enum class IfOccupied {
        wait,  // until the place is free
        next,  // the next place by the rules of the table's game (billiards::next_place)
    } if_occupied = IfOccupied::wait;
};

/// A ball is taken off the table.
struct RemoveBall {
    bool operator==(const RemoveBall&) const = default;
};

/// An occurrence in the shot, which starts an event (see ForceEvent) or names a time
/// (sim/event_time.h).
struct Trigger {
    enum class Kind {
        contact,
        potted,
        resting,
        crossing,
        strike,  // a stick strikes `a`
        apex,    // `a` is at the highest point of a flight; see kMinRise
    } kind = Kind::contact;
    std::string a;  // the object; empty with `resting`: all objects
    std::string b;  // contact only: the other object or surface
    // Crossing only: the centre of `a`, seen from above, passes between these two points (m) in
    // either direction.
    Vec2 from{0, 0}, to{0, 0};
    int nth = 1;  // which of the occurrences is meant, >= 1
};

/// A flight has an apex if the body rises by at least this much (m) without a pause. The hops of a
/// ball on the cloth are lower.
inline constexpr double kMinRise = 1e-3;

/// Impacts of the same two objects that follow each other within this time (s) are one contact.
inline constexpr double kOneContact = 0.01;

/// Acts at `time`, or with a trigger when that has happened for the `nth` time at or after `time`;
/// then plus `after`.
struct ForceEvent {
    std::string object;  // the body on which it acts
    double time = 0;     // scene time, s, >= 0
    std::optional<Trigger> trigger;
    double after = 0;  // delay, s, >= 0
    std::variant<Force, Torque, Impulse, SetVelocity, Strike, PlaceBall, RemoveBall> action;
};

}  // namespace carom::sim
