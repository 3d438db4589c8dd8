// The records of a shot: the event log, lasting contacts, balls put back and the energy.
#pragma once

#include <string>
#include <string_view>

#include "core/vectors.h"
#include "sim/timeline/surface.h"

namespace carom::sim {

enum class EventKind {
    impact,     // a and b collided and exchanged an impulse
    sliding,    // a began to slide on the cloth
    rolling,    // a began to roll without slip
    spinning,   // a began to spin about the vertical in place
    resting,    // a came to rest
    airborne,   // a left its support
    potted,     // a fell into pocket b
    off_table,  // a left the table and is not in a pocket
    force,      // force event: newtons on a from `time` to `end_time`
    torque,     // force event: newton metres on a from `time` to `end_time`
    impulse,    // force event: newton seconds on a
    velocity,   // force event: a's velocity was set
    strike,     // force event: the stick struck a; the vector is the velocity that it gave, the
                // normal impulse that of its tip
    placed,     // a was put down at rest on the cloth, on spot b (empty: not on a spot)
    removed,    // a was taken off the table
};

/// The name used in files: "impact", "rolling", "off_table" ...
[[nodiscard]] std::string_view to_string(EventKind kind);

struct Event {
    EventKind kind = EventKind::impact;
    double time = 0;       // scene time, s
    double end_time = 0;   // s; differs from `time` for force and torque only
    std::string a;         // name of the object
    std::string b;         // impact: the other object or surface ("cushion", "cloth", "floor" ...);
                           // potted: the pocket; placed: the spot
    Vec3 place{0, 0, 0};   // impact: the point of contact; placed: a's centre after it; otherwise
                           // a's centre
    Vec3 normal{0, 0, 0};  // impact: unit, from b towards a; otherwise zero
    double normal_impulse = 0;      // N s, impact and strike
    double tangential_impulse = 0;  // N s, impact only
    Vec3 vector{0, 0, 0};  // force events: the force, torque, impulse or velocity, world axes

    /// What b names in an impact, if it is not a body.
    [[nodiscard]] Surface surface() const {
        return kind == EventKind::impact ? surface_named(b) : Surface::none;
    }
    bool operator==(const Event&) const = default;
};

/// A lasting contact of two objects that move against each other, or a part of one: its force and
/// slip hardly change. docs/timeline.md says which contacts are recorded.
struct LastingContact {
    std::string a;            // name of an object
    std::string b;            // the other object or surface, as in Event
    double from = 0;          // scene time, s
    double to = 0;            // s, not before `from`
    double normal_force = 0;  // N, mean over that time
    double slip = 0;          // m/s, mean speed of the surfaces past each other while they touch

    /// What b names, if it is not a body.
    [[nodiscard]] Surface surface() const { return surface_named(b); }
    bool operator==(const LastingContact&) const = default;
};

/// A ball that is put down on the table, where its track jumps.
struct PutBack {
    std::string ball;
    double time = 0;     // scene time, s
    Vec3 from{0, 0, 0};  // its centre before
    Vec3 to{0, 0, 0};    // and after

    bool operator==(const PutBack&) const = default;
};

/// Mechanical energy of all dynamic bodies, joules; potential relative to z = 0.
struct EnergySample {
    double time = 0;
    double kinetic = 0;  // translation and rotation
    double potential = 0;
    double work = 0;  // that bodies moved by keys have done on the others since the start; of their
                      // impacts what it gave less what was lost there

    [[nodiscard]] double total() const { return kinetic + potential; }
    bool operator==(const EnergySample&) const = default;
};

}  // namespace carom::sim
