// A timeline summed up: what happened, how each object fared, where the energy went.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// Of one object at an event; the same twice where nothing jumped.
struct SpeedChange {
    double before = 0;  // m/s
    double after = 0;
    Vec3 spin_before{0, 0, 0};  // angular velocity, world axes, rad/s
    Vec3 spin_after{0, 0, 0};
};

struct ReportedEvent {
    sim::Event event;
    std::optional<SpeedChange> a;  // of the event's objects, where they move
    std::optional<SpeedChange> b;
    /// Two balls: between their approach and their line of centres, rad; 0 is a full hit.
    std::optional<double> cut;
};

enum class Fate { rests, spins, moves, potted, off_table };  // spins: on the spot

struct ReportedObject {
    std::string name;
    double path = 0;       // m
    double top_speed = 0;  // m/s
    double top_time = 0;   // s
    double rise = 0;       // of its centre above the start, m, at most
    int cushions = 0;      // touched
    Fate fate = Fate::rests;
    double fate_time = 0;  // since when it rests or spins, or when it went, s
    std::string pocket;    // potted only
    Vec3 place{0, 0, 0};   // at the end
    double speed = 0;      // at the end, m/s
};

/// The energy at the start, after each force event, and at the end.
struct ReportedEnergy {
    std::string when;  // "after the strike on cue"; empty at round times
    sim::EnergySample sample;
};

struct ShotReport {
    double start_time = 0;  // s
    double end_time = 0;
    std::vector<ReportedEvent> events;
    std::vector<ReportedObject> objects;
    std::vector<ReportedEnergy> energy;  // at the ends, after force events, at ten round times
    std::vector<sim::EnergySample> energy_samples;  // all that the timeline has
    double largest_energy_rise = 0;  // between force events, as in sim/timeline/energy.h
};

[[nodiscard]] ShotReport report_of(const sim::Timeline& timeline);

}  // namespace carom::pipeline
