// A summary of a timeline: events, the motion and final state of each object, and energy.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// Speed and spin of one object before and after an event; equal if the event does not change them.
struct SpeedChange {
    double before = 0;  // m/s
    double after = 0;
    Vec3 spin_before{0, 0, 0};  // angular velocity, world axes, rad/s
    Vec3 spin_after{0, 0, 0};
};

struct ReportedEvent {
    sim::Event event;
    std::optional<SpeedChange> a;  // speeds of the event's objects, if they have tracks
    std::optional<SpeedChange> b;
    /// For two balls the cut angle between relative velocity and line of centres, as seen from
    /// above, rad; 0 is a full hit. Nothing if one of the two is vertical.
    std::optional<double> cut;
    /// For impacts and strikes, if the film is known: when it makes them heard, s.
    std::optional<std::vector<double>> heard_at = {};
};

enum class Fate { rests, spins, moves, potted, off_table, removed };  // spins: in place

struct ReportedObject {
    std::string name;
    double path = 0;       // m
    double top_speed = 0;  // m/s
    double top_time = 0;   // s
    double rise = 0;       // largest height of its centre above the start, m
    int cushions = 0;      // number of cushions hit
    Fate fate = Fate::rests;
    double fate_time = 0;  // start of rest or of spinning in place, or time of leaving, s
    std::string pocket;    // potted only
    Vec3 place{0, 0, 0};   // at the end
    double speed = 0;      // at the end, m/s
};

/// The energy at one time of the table.
struct ReportedEnergy {
    std::string when;  // "after the strike on cue"; empty at the regular times
    sim::EnergySample sample;
};

/// A value of the shot that is a scene time named by what happens.
struct ReportedMoment {
    std::string key_path;        // "cameras[0].scene[1]"
    std::optional<double> time;  // s; empty: it never comes
};

struct ShotReport {
    double start_time = 0;  // s
    double end_time = 0;
    std::vector<ReportedEvent> events;
    std::vector<ReportedObject> objects;
    std::size_t all_events = 0;  // also those that a filter removes (report_parts.h)
    std::size_t all_objects = 0;
    std::vector<ReportedEnergy>
        energy;  // at the ends, after force events, at about ten regular times
    std::vector<sim::EnergySample> energy_samples;  // all samples of the timeline
    std::vector<ReportedMoment> moments;            // of the shot: report_of_shot
    double largest_energy_rise = 0;  // without the work of keyed objects: sim/timeline/energy.h
};

[[nodiscard]] ShotReport report_of(const sim::Timeline& timeline);
/// Of one of its objects.
[[nodiscard]] ReportedObject report_of(const sim::Timeline& timeline, const sim::Track& track);

}  // namespace carom::pipeline
